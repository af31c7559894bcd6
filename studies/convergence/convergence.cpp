#include "studies/convergence/convergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/base/unit_table.h"
#include "engine/run/run.h"
#include "studies/limit_states/limit_state.h"
#include "studies/prepare/run_job.h"
#include "studies/results/columns.h"
#include "studies/results/names.h"
#include "studies/statistics/quantiles.h"

namespace gurney::study {
namespace {

constexpr double kLongestStep = 0.02, kLoosestTolerance = 1e-3;

void scale_treads(Scene& scene, double factor) {
  for (PlacedItem& item : scene.items)
    for (Caster& caster : item.model.casters) {
      caster.tread.normal_stiffness *= factor;
      caster.tread.tangential_stiffness *= factor;
      caster.tread.normal_damping *= std::sqrt(factor);
      caster.tread.tangential_damping *= std::sqrt(factor);
    }
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
  const std::size_t values_of_task = motions.set_of(0).levels(0).size();
  ConvergenceCases cases;
  cases.of_runs = plan.runs();
  cases.limit_states = study.limit_states;
  const std::size_t all = plan.tasks_of_stage() * values_of_task, count = std::min(most, all);
  std::string last_problem;
  for (std::size_t i = 0; i < count; ++i) {
    // Tasks at equal distances; where they are fewer than the runs, each has several levels.
    const std::size_t task_index = i * plan.tasks_of_stage() / count;
    const Task task = plan.task(task_index);
    const MotionSet& set = motions.set_of(task.configuration);
    const double value = set.levels(task.record)[i % values_of_task];
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

/// Outcomes of one run that are kept.
struct Outcomes {
  std::string failure;  ///< empty: there is none
  std::vector<Demands> items;
  std::vector<bool> exceeded;  ///< by limit state
};

/// Change that nobody could measure, in the unit.
double smallest_change(const std::string& units, double time_step) {
  const SiUnit* const unit = si_unit(units);
  require(unit != nullptr, "convergence: no smallest change is stated for " + units);
  return std::isnan(unit->smallest_change) ? time_step : unit->smallest_change;
}

Outcomes outcomes_of(const RunCase& run, const std::vector<LimitState>& states) {
  Outcomes found;
  Response response;
  try {
    response = gurney::run(run.scene, run.floor, run.settings);
    if (is_failure(response.outcome)) found.failure = response.cause;
  } catch (const Error& error) {
    found.failure = error.what();
  }
  if (!found.failure.empty()) return found;
  for (const ItemResponse& item : response.items) found.items.push_back(item.demands);
  for (std::size_t i = 0; i < states.size(); ++i)
    found.exceeded.push_back(exceeded(states, i, values_of(run.scene, response)));
  return found;
}

using AllOutcomes = std::vector<std::vector<Outcomes>>;  ///< by variant, by run

AllOutcomes run_all(const ConvergenceCases& cases, const std::vector<Variant>& variants,
                    int threads) {
  AllOutcomes all(variants.size(), std::vector<Outcomes>(cases.runs.size()));
  const std::size_t count = cases.runs.size();
  parallel_for(variants.size() * count, threads, [&](std::size_t i) {
    all[i / count][i % count] =
        outcomes_of(varied(cases.runs[i % count], variants[i / count]), cases.limit_states);
  });
  return all;
}

/// Values of a number: of each variant those of its runs.
using ValuesByVariant = std::vector<std::vector<double>>;

ConvergedNumber number_of(const ValuesByVariant& values) {
  ConvergedNumber number;
  number.runs = values.front().size();
  for (const std::vector<double>& of_variant : values)
    number.values.push_back(statistics::quantile_of(of_variant, 0.5));
  if (number.runs < 2) return number;
  const statistics::Interval interval = statistics::median_interval(values.front()).interval;
  number.scatter = 0.5 * (interval.high - interval.low);
  if (!std::isfinite(number.scatter)) number.scatter = 0;  // too few to judge
  return number;
}

ConvergedNumber share_of(const ValuesByVariant& values) {
  ConvergedNumber number;
  number.runs = values.front().size();
  for (const std::vector<double>& of_variant : values)
    number.values.push_back(statistics::moments_of(of_variant).mean);
  const double share = number.values.front();
  number.scatter = 1.96 * std::sqrt(share * (1 - share) / static_cast<double>(number.runs));
  return number;
}

class Judge {
 public:
  Judge(const ConvergenceCases& cases, const AllOutcomes& all, Convergence& result)
      : cases_(cases), all_(all), result_(result) {
    for (std::size_t run = 0; run < cases.runs.size(); ++run)
      if (complete(run)) usable_.push_back(run);
  }

  void demands() {
    std::vector<std::string> names;
    for (const std::size_t run : usable_)
      for (const std::string& name : item_names(cases_.runs[run].scene))
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    for (const std::string& name : names)
      for (const TableColumn<Demands>& column : demand_columns()) add(name, column);
  }

  void limit_states() {
    for (std::size_t i = 0; i < cases_.limit_states.size() && !usable_.empty(); ++i) {
      ValuesByVariant values(all_.size());
      for (std::size_t variant = 0; variant < all_.size(); ++variant)
        for (const std::size_t run : usable_)
          values[variant].push_back(all_[variant][run].exceeded[i] ? 1 : 0);
      ConvergedNumber number = share_of(values);
      number.name = "exceeds " + cases_.limit_states[i].name;
      number.units = "1";
      finish(number);
    }
  }

 private:
  /// Whether the run came through in every variant; notes where it did not.
  bool complete(std::size_t run) {
    bool all = true;
    for (std::size_t variant = 0; variant < all_.size(); ++variant) {
      const std::string& failure = all_[variant][run].failure;
      if (failure.empty()) continue;
      if (all) result_.failed.push_back(cases_.names[run] + ": " + failure);
      all = false;
    }
    return all;
  }

  void add(const std::string& item, const TableColumn<Demands>& column) {
    ValuesByVariant values(all_.size());
    for (const std::size_t run : usable_) {
      const std::vector<std::string> names = item_names(cases_.runs[run].scene);
      const auto place = std::ranges::find(names, item);
      if (place == names.end()) continue;
      const auto index = static_cast<std::size_t>(place - names.begin());
      std::vector<double> of_run;
      for (const auto& outcomes : all_) of_run.push_back(column.value(outcomes[run].items[index]));
      if (std::ranges::any_of(of_run, [&](double v) { return column.is_missing(v); })) continue;
      for (std::size_t variant = 0; variant < all_.size(); ++variant)
        values[variant].push_back(of_run[variant]);
    }
    if (values.front().empty()) return;
    ConvergedNumber number = number_of(values);
    number.item = item;
    number.name = column.name;
    number.units = column.units;
    finish(number);
  }

  void finish(ConvergedNumber& number) {
    judge(number, result_.variants, result_.settings, result_.tolerance,
          smallest_change(number.units, result_.settings.time_step));
    result_.numbers.push_back(std::move(number));
  }

  const ConvergenceCases& cases_;
  const AllOutcomes& all_;
  Convergence& result_;
  std::vector<std::size_t> usable_;
};

/// Values by factor of what was varied, the job's own among them.
std::map<double, double> along(const ConvergedNumber& number, const std::vector<Variant>& variants,
                               Varied wanted) {
  std::map<double, double> values{{1.0, number.values.front()}};
  for (std::size_t i = 0; i < variants.size(); ++i)
    if (variants[i].varied == wanted) values[variants[i].factor] = number.values[i];
  return values;
}

/// Largest change over factors from `low` to `high`.
double largest_change(const std::map<double, double>& values, double low, double high,
                      double smallest) {
  double largest = 0;
  for (const auto& [factor, value] : values)
    if (factor >= low && factor <= high)
      largest = std::max(largest, relative_change(values.at(1.0), value, smallest));
  return largest;
}

}  // namespace

std::vector<Variant> variants_for(const SimulationSettings& settings) {
  std::vector<Variant> variants{{Varied::kTimeStep, 1}};
  for (const double factor : {2.0, 0.5, 0.25, 0.125})
    if (factor * settings.time_step <= kLongestStep)
      variants.push_back({Varied::kTimeStep, factor});
  for (const double factor : {1e3, 1e-2})
    if (factor * settings.residual <= kLoosestTolerance)
      variants.push_back({Varied::kSolverTolerance, factor});
  for (const double factor : {0.25, 0.5, 2.0, 4.0})
    variants.push_back({Varied::kTreadStiffness, factor});
  return variants;
}

RunCase varied(RunCase run, const Variant& variant) {
  switch (variant.varied) {
    case Varied::kTimeStep:
      lengthen_steps(variant.factor, run.settings);
      break;
    case Varied::kSolverTolerance:
      run.settings.residual *= variant.factor;
      break;
    case Varied::kTreadStiffness:
      scale_treads(run.scene, variant.factor);
      break;
  }
  return run;
}

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

std::string name_of(StepVerdict verdict) {
  constexpr std::array kNames{"converged", "needs a smaller step", "below the scatter",
                              "sensitive"};
  return kNames.at(static_cast<std::size_t>(verdict));
}

Convergence converge(const ConvergenceCases& cases, double tolerance, int threads) {
  Convergence result;
  result.settings = cases.runs.front().settings;
  result.tolerance = tolerance;
  result.variants = variants_for(result.settings);
  result.runs = cases.runs.size();
  result.of_runs = cases.of_runs;
  const AllOutcomes all = run_all(cases, result.variants, threads);
  Judge judge(cases, all, result);
  judge.demands();
  judge.limit_states();
  return result;
}

double relative_change(double a, double b, double smallest) {
  const double difference = std::abs(a - b);
  return difference <= smallest ? 0 : difference / std::max(std::abs(a), std::abs(b));
}

void judge(ConvergedNumber& number, const std::vector<Variant>& variants,
           const SimulationSettings& settings, double tolerance, double smallest) {
  const auto step = along(number, variants, Varied::kTimeStep);
  const double whole = step.at(1), half = step.at(0.5), quarter = step.at(0.25),
               eighth = step.at(0.125);
  number.change = relative_change(whole, eighth, smallest);
  const double first = std::abs(whole - half), second = std::abs(half - quarter),
               third = std::abs(quarter - eighth);
  number.order = first > 0 && second > 0 ? std::log2(first / second)
                                         : std::numeric_limits<double>::quiet_NaN();
  number.solver_change =
      largest_change(along(number, variants, Varied::kSolverTolerance), 0, 1, smallest);
  number.stiffness_change =
      largest_change(along(number, variants, Varied::kTreadStiffness), 0.5, 2, smallest);
  number.step_needed = settings.time_step;
  if (number.change <= tolerance) {
    number.step = StepVerdict::kConverged;
  } else if (std::abs(whole - eighth) <= 0.5 * number.scatter) {
    number.step = StepVerdict::kScattered;
  } else if (second <= 0.75 * first && third <= 0.75 * second) {
    number.step = StepVerdict::kConverging;
    const double order = std::clamp(number.order, 0.5, 2.0);
    number.step_needed *= std::pow(tolerance / number.change, 1 / order);
  } else {
    number.step = StepVerdict::kSensitive;
  }
}

}  // namespace gurney::study
