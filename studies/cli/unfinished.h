#pragma once

#include <string>

namespace gurney::cli {

/// The results that the folder FILE.h5.parts, or FILE.h5.shards, will become.
std::string results_of_folder(const std::string& folder);

/// The path of the job in such a folder, or in the log beside the results.
std::string job_of_folder(const std::string& folder);

}  // namespace gurney::cli
