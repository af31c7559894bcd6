#pragma once

#include <string>

namespace gurney::cli {

/// The job file that the log beside a results file names last, from the folder where it ran unless it
/// is found from here; empty: none.
std::string job_of_log(const std::string& results);

}  // namespace gurney::cli
