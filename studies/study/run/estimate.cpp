#include "studies/study/run/estimate.h"

#include <sys/resource.h>

#include <chrono>
#include <vector>

#include "engine/baselines/any_solver.h"

namespace gurney::study {
namespace {

struct Trial {
  double seconds = 0;
  std::size_t bytes = 0;
};

Trial make_run(const Batch& batch, std::size_t index, double value) {
  const auto start = std::chrono::steady_clock::now();
  const Study& study = batch.job.study();
  const Task task = batch.plan.task(index);
  const bool by_measure = study.intensity.kind != IntensityPlan::Kind::kScales;
  const Job job = batch.job.job(task.configuration, batch.plan.draw(task));
  StudyRun run;
  run.scale =
      by_measure ? batch.motions.set_of(task.configuration).scale_for(task.record, value) : value;
  RunCase of_run = case_of(batch, task, job, run.scale);
  if (study.keep.histories == Histories::kNone) of_run.settings.history_step = 0;
  run.response = baselines::simulate_with_any_solver(of_run.scene, of_run.floor, of_run.settings);
  if (study.keep.histories != Histories::kAll)
    for (ItemResponse& item : run.response.items) item.history.clear();
  TaskResult result;
  result.task = index;
  result.runs.push_back(std::move(run));
  const std::size_t bytes = to_bytes(result).size();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), bytes};
}

}  // namespace

Estimate estimate(const Batch& batch) {
  const IntensityPlan& plan = batch.job.study().intensity;
  const bool ida = plan.kind == IntensityPlan::Kind::kIda;
  const double low = ida ? plan.first : plan.levels.front();
  const double high = ida ? plan.first + 3 * plan.increment : plan.levels.back();
  const Trial first = make_run(batch, 0, low);
  const Trial last = make_run(batch, batch.plan.tasks_of_stage() - 1, high);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  // A run that is repeated with half the step costs three.
  const double again = 1 + 2 * batch.job.study().step_check;
  return {.runs = batch.plan.runs(),
          .seconds_per_run = again * 0.5 * (first.seconds + last.seconds),
          .bytes_per_run = 0.5 * static_cast<double>(first.bytes + last.bytes),
          .memory_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024};
}

}  // namespace gurney::study
