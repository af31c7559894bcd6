#pragma once

#include <filesystem>
#include <string>

#include "equipment/catalogue/catalogue.h"

namespace gurney::cli {

/// The file of an item or of other data on the command line: a name of the catalogue, or a path.
/// @throws Error that begins with `option` and what was written
std::string data_file(equipment::DataKind kind, const std::string& name,
                      const std::string& option = "");

/// The results file that a command writes. @throws Error unless it ends in .h5
std::filesystem::path results_file(const std::filesystem::path& path);

/// Refuses files that are often named in the place of a job, with the command that takes them.
/// @param command  that wants a job
/// @throws Error for a results file and for a file of a record
void require_job(const std::string& path, const std::string& command);

}  // namespace gurney::cli
