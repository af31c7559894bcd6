#pragma once

#include <string>

namespace gurney::cli {

/// The file of an item on the command line: a name of the catalogue, or a path.
/// @throws Error that begins with what was written
std::string item_file(const std::string& name);

/// Refuses files that are often named in the place of a job, with the command that takes them.
/// @param command  that wants a job
/// @throws Error for a results file and for a file of a record
void require_job(const std::string& path, const std::string& command);

}  // namespace gurney::cli
