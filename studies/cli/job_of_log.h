#pragma once

#include <string>

namespace gurney::cli {

/// The job file that the log beside a results file names last; empty: none.
std::string job_of_log(const std::string& results);

}  // namespace gurney::cli
