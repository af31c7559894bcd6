#pragma once

#include <filesystem>
#include <vector>

#include "groundmotions/suites/suite.h"

namespace gurney::groundmotions {

/// The records in a folder and the folders in it, in order of their paths; hidden files are passed
/// over.
///
/// Every file is read once. A file with several components is a record, or one for each of its
/// sites; files with one component are put together (grouping.h). PEER search reports group the
/// files they name. Velocities and displacements beside their acceleration are passed over
/// (companions()). A file that is not a record is refused with its reason.
/// @param options  for the files that cannot be read without them
/// @throws Error if the folder holds no files.
Suite read_folder_suite(const std::filesystem::path& folder, const ReadOptions& options = {},
                        const Progress& progress = {});

/// The same for files in the order given; the options are checked against what the files say.
Suite group_files(const std::vector<std::filesystem::path>& files, const ReadOptions& options = {},
                  const Progress& progress = {});

/// Takes the velocities and displacements out of `files` whose acceleration is among them: X.VT2
/// and X.DT2 beside X.AT2, X.vel and X.dis beside X.acc, X.VEL.ASC beside X.ACC.ASC, letter case
/// apart.
/// @returns how many were taken out
std::size_t drop_companions(std::vector<std::filesystem::path>& files);

}  // namespace gurney::groundmotions
