#pragma once

#include "groundmotions/suites/suite.h"

namespace gurney {

/// The records in a folder and the folders in it, in order of their paths; hidden files are passed
/// over.
///
/// Every file is read once. A file with several components is a record. Files with one component
/// belong together if their names are the same but for the component's name (RRS228, RRS318,
/// RRS-UP; .EW, .NS, .UD; HNE, HNN, HNZ), or else, where the name does not contain it, if folder,
/// event and station in their headers are the same. PEER search reports group the files they name.
/// What is no record is refused with its reason.
/// @param options  for the files that cannot be read without them
/// @throws Error if the folder holds no files.
Suite read_folder_suite(const std::filesystem::path& folder, const ReadOptions& options = {},
                        const Progress& progress = {});

/// The same for files in the order given; the options are checked against what the files say.
Suite group_files(const std::vector<std::filesystem::path>& files, const ReadOptions& options = {},
                  const Progress& progress = {});

/// The name of a component's file without the name of the component: "RSN1063_NORTHR_RRS228.AT2"
/// of component "228" is "RSN1063_NORTHR_RRS*.AT2". Empty if the component's name is not in it.
std::string name_without_component(const std::string& file_name, const std::string& component);

}  // namespace gurney
