#pragma once

#include <string>

namespace gurney::cli {

/// The job file that the log beside a results file names last, from the folder where it ran unless it
/// is found from here; empty: none.
std::string job_of_log(const std::string& results);

/// What is said of the job of results where nothing has its path: "does not exist any more", or why
/// the system cannot look for it.
std::string why_not_there(const std::string& path);

}  // namespace gurney::cli
