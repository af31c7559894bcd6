#pragma once

#include <string>

#include "studies/run/run_task.h"

namespace gurney::study {

/// How the job, the records and the data files of a study differ from those of a results file;
/// empty: they are the same. The program that made the results may be another.
/// @throws Error for a file that is not a results file of a study
std::string difference_to_results(const std::string& path, const Batch& batch);

}  // namespace gurney::study
