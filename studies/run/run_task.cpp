#include "studies/run/run_task.h"

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "engine/run/run.h"
#include "studies/limit_states/limit_state.h"
#include "studies/plan/stages.h"
#include "studies/results/names.h"

namespace gurney::study {
namespace {

double peak_of(const FloorMotion& floor, bool velocity) {
  double peak = 0;
  for (Eigen::Index i = 0; i < floor.acceleration().cols(); ++i) {
    const double time = static_cast<double>(i) * floor.time_step();
    const Vector3 value = velocity ? floor.velocity_at(time) : floor.acceleration().col(i);
    peak = std::max(peak, value.head<2>().norm());
  }
  return peak;
}

bool wanted(Histories histories, Outcome outcome) {
  switch (histories) {
    case Histories::kNone:
      return false;
    case Histories::kFailed:
      return is_failure(outcome);
    case Histories::kOverturned:
      return outcome == Outcome::kOverturned;
    case Histories::kAll:
      return true;
  }
  return false;
}

/// A draw that makes no valid job, such as items that overlap.
Response failed(const std::string& cause) {
  Response response;
  response.outcome = Outcome::kDiverged;
  response.cause = cause;
  return response;
}

/// Whether the run is among the fraction that is repeated with half the step.
bool is_checked(const Study& study, std::size_t task, std::size_t run) {
  constexpr std::uint64_t kStream = 0x63657274;  // "cert"
  return uniform_draw(study.seed, kStream + run, task) < study.step_check;
}

/// Demands at half the step go to `result`, or, where that run fails, a warning.
void repeat_at_half_step(RunCase run, StudyRun& result) {
  lengthen_steps(0.5, run.settings);
  run.settings.history_step = 0;
  Response response;
  try {
    response = gurney::run(run.scene, run.floor, run.settings);
  } catch (const Error& error) {
    response = failed(error.what());
  }
  if (is_failure(response.outcome)) {
    result.warnings.push_back(kHalfStepFailed + response.cause);
    return;
  }
  for (const ItemResponse& item : response.items) result.at_half_step.push_back(item.demands);
}

void simulate_case(const Batch& batch, const Task& task, const Job& job, bool checked,
                   StudyRun& run) {
  try {
    RunCase of_run = case_of(batch, task, job, run.scale);
    if (batch.job.study().keep.histories == Histories::kNone) of_run.settings.history_step = 0;
    run.warnings = of_run.warnings;
    run.pfa = peak_of(of_run.floor, false);
    run.pfv = peak_of(of_run.floor, true);
    run.response = gurney::run(of_run.scene, of_run.floor, of_run.settings);
    if (checked && !is_failure(run.response.outcome)) repeat_at_half_step(std::move(of_run), run);
  } catch (const Error& error) {
    run.response = failed(error.what());
  }
}

}  // namespace

RunCase case_of(const Batch& batch, const Task& task, const Job& job, double scale) {
  RunCase run{job.scene, {}, job.settings, {}};
  run.floor = batch.motions.set_of(task.configuration)
                  .floor(task.record, scale, batch.job.study().angles[task.angle], run.warnings)
                  .with_rocking_times(job.rotation_factor);
  return run;
}

TaskResult run_task(const Batch& batch, std::size_t index, const std::function<bool()>& go_on,
                    const CrashedRuns& crashed, const std::vector<double>* levels) {
  const Study& study = batch.job.study();
  const Task task = batch.plan.task(index);
  const MotionSet& motions = batch.motions.set_of(task.configuration);
  const bool by_measure = study.intensity.kind != IntensityPlan::Kind::kScales;
  TaskResult result;
  result.task = index;
  std::optional<Job> job;
  std::string bad;
  try {
    job = batch.job.job(task.configuration, batch.plan.draw(task), task.replica);
    for (const equipment::Assumption& each : job->assumptions)
      if (!each.distribution.empty()) result.drawn.push_back(each.value);
  } catch (const Error& error) {
    bad = error.what();
  }
  IntensityPlan plan = study.intensity;
  plan.levels = levels != nullptr ? *levels : motions.levels(task.record);
  Intensities intensities(plan);
  while (const std::optional<double> value = intensities.next()) {
    if (!go_on()) return {};
    StudyRun run;
    run.scale = by_measure ? motions.scale_for(task.record, *value) : *value;
    run.intensity = by_measure ? *value : 0;
    const std::size_t number = result.runs.size();
    if (const auto known = crashed.find({index, number}); known != crashed.end()) {
      run.response = failed(known->second);
    } else if (job) {
      const RunMark mark(index, number);
      simulate_case(batch, task, *job, is_checked(study, index, number), run);
    } else {
      run.response = failed(bad);
    }
    if (!wanted(study.keep.histories, run.response.outcome))
      for (ItemResponse& item : run.response.items) item.history.clear();
    run.until =
        job && !is_failure(run.response.outcome) &&
        exceeded(study.limit_states, study.intensity.until, values_of(job->scene, run.response));
    intensities.report(*value, run.until);
    if (is_failure(run.response.outcome) && study.intensity.kind == IntensityPlan::Kind::kIda)
      intensities.stop();
    result.runs.push_back(std::move(run));
  }
  return result;
}

}  // namespace gurney::study
