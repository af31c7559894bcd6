#pragma once

#include <string>

namespace gurney::study {

/// Where the job that a results file keeps is read again, for messages and relative names: the path
/// of its file, or a name beside the results where that is empty.
std::string place_of_job(const std::string& job, const std::string& results);

}  // namespace gurney::study
