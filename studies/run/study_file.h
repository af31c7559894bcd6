#pragma once

#include <functional>
#include <string>

#include "studies/run/run_task.h"

namespace gurney::study {

/// Writes the results of a study, task by task in their order, so that the same study gives the
/// same bytes however it was run. Memory does not grow with the number of runs.
/// @param path  of a file that is made, not yet the one the user asked for
/// @param read  the result of a task
/// @param has   whether a task is finished; empty: all are
/// @throws Error where the file cannot be written
RunCounts write_study_file(const std::string& path, const Batch& batch,
                           const std::function<TaskResult(std::size_t)>& read,
                           const std::function<bool(std::size_t)>& has = {});

/// How the job, the records and the data files of a study differ from those of a results file;
/// empty: they are the same. The program that made the results may be another.
/// @throws Error for a file that is not a results file of a study
std::string difference_to_results(const std::string& path, const Batch& batch);

}  // namespace gurney::study
