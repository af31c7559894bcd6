#pragma once

#include <filesystem>
#include <string>

#include "studies/templates/templates.h"

namespace gurney::cli {

/// Lets a study run over the records found in a folder: the folder, or the files of it that can be
/// read. All three components are used if more than half of the records have them, else both
/// horizontals, else what all have. Records that lack one of these, or that need a factor above
/// kDubiousFactor for the highest level, are left out: their files stay as comments.
/// @param unit  of files that do not state theirs; empty: all do
/// @param file  the job that will name them
/// @returns `3 of 5 records; the file states why the others are excluded`
/// @throws Error if there are no records, with the reasons
std::string use_records(const std::filesystem::path& folder, const std::string& unit,
                        const std::filesystem::path& file, templates::Wishes& wishes);

}  // namespace gurney::cli
