#include "studies/convergence/convergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/run/run.h"
#include "studies/convergence/judge.h"
#include "studies/limit_states/response_values.h"
#include "studies/results/columns.h"
#include "studies/results/names.h"
#include "studies/statistics/median_interval.h"
#include "studies/statistics/quantiles.h"

namespace gurney::study {
namespace {

/// What is kept of one run.
struct Outcomes {
  std::string failure;  ///< empty: there is none
  std::vector<Demands> items;
  std::vector<bool> exceeded;  ///< by limit state
};

/// Change that nobody could measure, in the unit.
double smallest_change(const std::string& units, double time_step) {
  static const std::map<std::string, double> kSmallest = {{"m", 1e-4}, {"m/s", 1e-3}, {"rad", 1e-4},
                                                          {"N", 0.1},  {"N s", 0.1},  {"1", 0}};
  if (units == "s") return time_step;
  const auto found = kSmallest.find(units);
  require(found != kSmallest.end(), "convergence: no smallest change is stated for " + units);
  return found->second;
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

/// Values of a number, by variant and run.
using Values2 = std::vector<std::vector<double>>;

ConvergedNumber number_of(const Values2& values) {
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

ConvergedNumber share_of(const Values2& values) {
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
      Values2 values(all_.size());
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
    Values2 values(all_.size());
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

}  // namespace

std::string name_of(StepVerdict verdict) {
  switch (verdict) {
    case StepVerdict::kConverged:
      return "converged";
    case StepVerdict::kConverging:
      return "needs a smaller step";
    case StepVerdict::kScattered:
      return "below the scatter";
    case StepVerdict::kSensitive:
      break;
  }
  return "sensitive";
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

}  // namespace gurney::study
