#include "studies/run/estimate.h"

#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "engine/run/run.h"

namespace gurney::study {
namespace {

constexpr std::size_t kMaxTimed = 8;
constexpr double kLongEnough = 2;  // [s]

struct Trial {
  double seconds = 0;
  std::size_t bytes = 0;
  std::vector<std::string> warnings;
};

double processor_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Trial make_run(const Batch& batch, std::size_t index, double value) {
  const double start = processor_time();
  const Study& study = batch.job.study();
  const Task task = batch.plan.task(index);
  const bool by_measure = study.intensity.kind != IntensityPlan::Kind::kScales;
  const Job job = batch.job.job(task.configuration, batch.plan.draw(task));
  StudyRun run;
  run.scale =
      by_measure ? batch.motions.set_of(task.configuration).scale_for(task.record, value) : value;
  RunCase of_run = case_of(batch, task, job, run.scale);
  if (study.keep.histories == Histories::kNone) of_run.settings.history_step = 0;
  run.response = gurney::run(of_run.scene, of_run.floor, of_run.settings);
  if (study.keep.histories != Histories::kAll)
    for (ItemResponse& item : run.response.items) item.history.clear();
  TaskResult result;
  result.task = index;
  const std::vector<std::string> warnings = of_run.warnings;
  result.runs.push_back(std::move(run));
  const std::size_t bytes = to_bytes(result).size();
  return {processor_time() - start, bytes, warnings};
}

/// Place i of n in a range, in an order that does not rise with i: tasks and intensities are not
/// paired, low with low.
std::size_t scattered(std::size_t i, std::size_t n, std::size_t size) {
  constexpr std::size_t kOrder[kMaxTimed] = {0, 7, 3, 5, 1, 6, 2, 4};
  return n < 2 ? 0 : std::min(size - 1, kOrder[i] * size / kMaxTimed);
}

}  // namespace

Estimate estimate(const Batch& batch) {
  const auto values_of = [&](std::size_t index) {
    const Task task = batch.plan.task(index);
    return batch.motions.set_of(task.configuration).levels(task.record);
  };
  const std::size_t values = values_of(0).size();
  const std::size_t tasks = batch.plan.tasks_of_stage();
  const std::size_t most = std::min(kMaxTimed, tasks * values);
  Estimate result;
  result.runs = batch.plan.runs();
  make_run(batch, 0, values_of(0).front());
  double seconds = 0, bytes = 0;
  while (result.timed < most && (result.timed < 2 || seconds < kLongEnough)) {
    const std::size_t i = result.timed++;
    const std::size_t task = most < 2 ? 0 : i * (tasks - 1) / (most - 1);
    const Trial trial = make_run(batch, task, values_of(task)[scattered(i, most, values)]);
    seconds += trial.seconds;
    bytes += static_cast<double>(trial.bytes);
    for (const std::string& warning : trial.warnings)
      if (std::ranges::find(result.warnings, warning) == result.warnings.end())
        result.warnings.push_back(warning);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  // A run that is repeated with half the step costs three.
  const double again = 1 + 2 * batch.job.study().step_check;
  const auto timed = static_cast<double>(result.timed);
  result.seconds_per_run = again * seconds / timed;
  result.bytes_per_run = bytes / timed;
  result.memory_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  return result;
}

}  // namespace gurney::study
