#pragma once

#include <functional>
#include <string>
#include <vector>

#include "studies/plan/plan.h"
#include "studies/run/crash_log.h"
#include "studies/run/task_result.h"

namespace gurney::study {

/// Inputs that the tasks of a study share; constant while they run.
struct Batch {
  const StudyJob& job;
  const StudyMotions& motions;
  const Plan& plan;
};

/// Input of run() (engine/run) for one run.
struct RunCase {
  Scene scene;
  FloorMotion floor;
  RunOptions settings;
  std::vector<std::string> warnings;  ///< of the building under this motion
};

/// @param job    of the task's configuration and draw
/// @param scale  on the ground motion
RunCase case_of(const Batch& batch, const Task& task, const Job& job, double scale);

/// Makes the runs of one task: the same numbers in any thread, process and order.
/// @param go_on  asked before each run; false: the task is dropped
/// @param crashed  runs that fail without being tried
/// @param levels   of its configuration in its stage; null: the first
/// @return no runs when it was dropped
TaskResult run_task(const Batch& batch, std::size_t index, const std::function<bool()>& go_on,
                    const CrashedRuns& crashed = {}, const std::vector<double>* levels = nullptr);

}  // namespace gurney::study
