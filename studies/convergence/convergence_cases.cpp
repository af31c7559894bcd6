#include "studies/convergence/convergence_cases.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"
#include "studies/prepare/run_job.h"

namespace gurney::study {
namespace {

constexpr std::size_t kStepsOfIda = 4;

std::vector<double> values_of(const IntensityPlan& plan) {
  if (plan.kind != IntensityPlan::Kind::kIda) return plan.levels;
  std::vector<double> values{plan.first};
  for (std::size_t step = 1; step < kStepsOfIda; ++step)
    values.push_back(values.back() + static_cast<double>(step) * plan.increment);
  return values;
}

std::string name_of_run(const Batch& batch, const Task& task, double value) {
  const IntensityPlan& plan = batch.job.study().intensity;
  const auto& levels = batch.job.configurations()[task.configuration].levels;
  const std::string& record = batch.motions.set_of(task.configuration).name(task.record);
  return fmt::format("{}{}{}, {:g} {}", fmt::join(levels, ", "), levels.empty() ? "" : ", ",
                     record.empty() ? "the floor rests" : record, value / plan.unit_in_si,
                     plan.kind == IntensityPlan::Kind::kScales ? "x" : plan.unit);
}

ConvergenceCases cases_of_study(const StudyJob& job, std::size_t most, int threads) {
  const StudyMotions motions(job);
  motions.read_all(threads);
  const Plan plan(job, motions);
  const Batch batch{job, motions, plan};
  const Study& study = job.study();
  const std::vector<double> values = values_of(study.intensity);
  ConvergenceCases cases;
  cases.of_runs = plan.runs();
  cases.limit_states = study.limit_states;
  const std::size_t all = plan.tasks_of_stage() * values.size(), count = std::min(most, all);
  std::string last_problem;
  for (std::size_t i = 0; i < count; ++i) {
    // Units in equal distances; where there are fewer than runs, each has several levels.
    const std::size_t task_index = i * plan.tasks_of_stage() / count;
    const Task task = plan.task(task_index);
    const double value = values[i % values.size()];
    const MotionSet& set = motions.set_of(task.configuration);
    const double scale = study.intensity.kind == IntensityPlan::Kind::kScales
                             ? value
                             : set.scale_for(task.record, value);
    try {
      cases.runs.push_back(
          case_of(batch, task, job.job(task.configuration, plan.draw(task)), scale));
      cases.names.push_back(name_of_run(batch, task, value));
    } catch (const Error& error) {
      last_problem = error.what();
    }
  }
  require(!cases.runs.empty(), last_problem);
  return cases;
}

}  // namespace

ConvergenceCases convergence_cases(const std::string& job, std::size_t most, int threads) {
  ConvergenceCases cases;
  if (has_study(job)) {
    cases = cases_of_study(StudyJob(job), most, threads);
  } else {
    PreparedRun run = prepare_run(job);
    cases.runs.push_back({std::move(run.facts.scene), std::move(run.facts.floor),
                          run.facts.settings, run.facts.warnings});
    cases.names.push_back(run.facts.record ? run.facts.record->name : "the floor rests");
  }
  for (RunCase& run : cases.runs) run.settings.history_step = run.settings.peak_error = 0;
  return cases;
}

}  // namespace gurney::study
