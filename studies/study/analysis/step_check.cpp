#include "studies/study/analysis/step_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "studies/statistics/quantiles.h"
#include "studies/study/analysis/replica_cases.h"
#include "studies/study/results/columns.h"
#include "studies/study/results/names.h"

namespace gurney::study {
namespace {

using Rows = std::vector<std::pair<std::size_t, std::size_t>>;

/// Rows of /items and of /half_step that are the same item of the same run.
struct Pair {
  std::size_t run, full, half;
};

std::vector<Pair> pairs_of(const Rows& full, const Rows& half) {
  std::vector<Pair> pairs;
  for (std::size_t run = 0; run < half.size(); ++run)
    for (std::size_t i = 0; i < half[run].second - half[run].first; ++i)
      if (full[run].first + i < full[run].second)
        pairs.push_back({run, full[run].first + i, half[run].first + i});
  return pairs;
}

double relative_change(double full, double half) {
  const double size = std::max(std::abs(full), std::abs(half));
  return size > 0 ? std::abs(half - full) / size : 0;
}

/// Whether the file has a demand at both steps: it may be of a program that did not know it.
bool has_both(const StudyReader& file, const std::string& demand) {
  return file.has_column("items/" + demand) && file.has_column("half_step/" + demand);
}

StepChange change_of(const StudyReader& file, const TableColumn<Demands>& column,
                     const std::vector<Pair>& pairs) {
  const std::vector<double> full = file.numbers(std::string("items/") + column.name);
  const std::vector<double> half = file.numbers(std::string("half_step/") + column.name);
  StepChange change{column.name};
  std::vector<double> changes;
  for (const Pair& pair : pairs) {
    if (column.is_missing(full[pair.full]) || column.is_missing(half[pair.half])) continue;
    const double value = relative_change(full[pair.full], half[pair.half]);
    if (value > change.largest) {
      change.largest = value;
      change.largest_run = pair.run;
    }
    changes.push_back(value);
  }
  change.compared = changes.size();
  if (!changes.empty()) change.median = statistics::quantile_of(changes, 0.5);
  return change;
}

bool of_items(const std::vector<LimitState>& states, std::size_t index) {
  const LimitState& state = states[index];
  if (state.kind == LimitState::Kind::kAbove || state.kind == LimitState::Kind::kBelow)
    return state.quantity.of == Quantity::Of::kItem;
  return std::ranges::all_of(state.parts, [&](std::size_t part) { return of_items(states, part); });
}

/// Demands of the items of runs from a table like /items.
class ItemTable {
 public:
  ItemTable(const StudyReader& file, std::string table)
      : file_(file), table_(std::move(table)), rows_(file.rows_of_runs(table_)) {
    items_ = file.strings(table_ + "/item");
  }

  const Rows& rows() const { return rows_; }

  Values of_run(std::size_t run) {
    return [this, run](const Quantity& quantity) {
      std::vector<double>& column = columns_[quantity.column];
      if (column.empty()) column = file_.numbers(table_ + "/" + quantity.column);
      std::vector<double> values;
      for (std::size_t row = rows_[run].first; row < rows_[run].second; ++row)
        if (quantity.item.empty() || items_[row] == quantity.item) values.push_back(column[row]);
      return values;
    };
  }

 private:
  const StudyReader& file_;
  std::string table_;
  Rows rows_;
  std::vector<std::string> items_;
  std::map<std::string, std::vector<double>> columns_;
};

/// Logarithms of a demand that is above 0 at both steps.
StepDistribution distribution_of(const StudyReader& file, const TableColumn<Demands>& column,
                                 const std::vector<Pair>& pairs,
                                 const std::vector<double>& records) {
  const std::vector<double> full = file.numbers(std::string("items/") + column.name);
  const std::vector<double> half = file.numbers(std::string("half_step/") + column.name);
  std::vector<statistics::Measured> a, b;
  for (const Pair& pair : pairs) {
    const double at_full = full[pair.full], at_half = half[pair.half];
    if (column.is_missing(at_full) || column.is_missing(at_half)) continue;
    if (!(at_full > 0) || !(at_half > 0)) continue;
    const auto record = static_cast<std::size_t>(records[pair.run]);
    a.push_back({std::log(at_full), record});
    b.push_back({std::log(at_half), record});
  }
  return {column.name, statistics::paired_difference(a, b)};
}

/// Takes what belongs to chaotic runs out of `all`.
template <class Type, class RunOf>
std::vector<Type> taken(std::vector<Type>& all, const std::vector<bool>& chaotic, RunOf run_of) {
  std::vector<Type> out;
  for (const Type& each : all)
    if (chaotic[run_of(each)]) out.push_back(each);
  std::erase_if(all, [&](const Type& each) { return chaotic[run_of(each)]; });
  return out;
}

std::size_t failed_repetitions(const StudyReader& file) {
  if (!file.has("warnings")) return 0;
  return static_cast<std::size_t>(std::ranges::count_if(
      file.strings("warnings/warning"),
      [](const std::string& warning) { return warning.starts_with(kHalfStepFailed); }));
}

}  // namespace

std::optional<StepCheck> step_check(const StudyData& data) {
  if (!data.file().has("half_step")) return {};
  ItemTable full(data.file(), "items"), half(data.file(), "half_step");
  StepCheck step_check;
  std::vector<std::size_t> runs;
  for (std::size_t run = 0; run < half.rows().size(); ++run)
    if (half.rows()[run].second > half.rows()[run].first) runs.push_back(run);
  step_check.runs = runs.size();
  step_check.failed = failed_repetitions(data.file());
  std::vector<Pair> pairs = pairs_of(full.rows(), half.rows());
  const std::vector<bool> chaotic = in_chaotic_cases(data.file());
  const std::vector<double> records = data.file().numbers("runs/record");
  const auto chaotic_runs = taken(runs, chaotic, [](std::size_t run) { return run; });
  const auto chaotic_pairs = taken(pairs, chaotic, [](const Pair& pair) { return pair.run; });
  if (!chaotic_runs.empty()) step_check.chaotic = ChaoticStepCheck{chaotic_runs.size(), {}, {}};
  for (const TableColumn<Demands>& column : demand_columns()) {
    if (!has_both(data.file(), column.name)) continue;
    step_check.changes.push_back(change_of(data.file(), column, pairs));
    if (step_check.chaotic)
      step_check.chaotic->demands.push_back(
          distribution_of(data.file(), column, chaotic_pairs, records));
  }
  const std::vector<LimitState>& states = data.limit_states();
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!of_items(states, i)) {
      step_check.unjudged.push_back(states[i].name);
      continue;
    }
    StateChange change{states[i].name, {}};
    for (const std::size_t run : runs)
      if (exceeded(states, i, full.of_run(run)) != exceeded(states, i, half.of_run(run)))
        change.runs.push_back(run);
    step_check.states.push_back(change);
    if (!step_check.chaotic) continue;
    std::vector<statistics::Measured> a, b;
    for (const std::size_t run : chaotic_runs) {
      const auto record = static_cast<std::size_t>(records[run]);
      a.push_back({exceeded(states, i, full.of_run(run)) ? 1.0 : 0.0, record});
      b.push_back({exceeded(states, i, half.of_run(run)) ? 1.0 : 0.0, record});
    }
    step_check.chaotic->states.push_back({states[i].name, statistics::paired_difference(a, b)});
  }
  return step_check;
}

}  // namespace gurney::study
