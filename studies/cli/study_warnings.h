#pragma once

#include <string>
#include <vector>

#include "studies/plan/study_job.h"

namespace gurney::cli {

/// "8: the first; the second; ...", with the first six.
std::string list_of(const std::vector<std::string>& all);

/// Warnings of a study's job, each with the configurations that it is of where it is not of all.
std::vector<std::string> job_warnings(const study::StudyJob& job);

}  // namespace gurney::cli
