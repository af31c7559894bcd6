#include "studies/analysis/step_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "engine/response/settled.h"
#include "studies/analysis/replica_spread.h"
#include "studies/results/columns.h"
#include "studies/results/names.h"
#include "studies/statistics/quantiles.h"

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

/// A table of demands and that of the same runs at half the step.
struct Tables {
  const char *full, *half;
};
constexpr Tables kItems{"items", "half_step"}, kPoints{"points", "half_step_points"};

/// Whether the file has a demand at both steps: it may be of a program that did not know it.
bool has_both(const StudyReader& file, const Tables& tables, const std::string& demand) {
  return file.has_column(std::string(tables.full) + "/" + demand) &&
         file.has_column(std::string(tables.half) + "/" + demand);
}

/// Marked points only where the study kept them at half the step.
bool has_points(const StudyReader& file) { return file.has(kPoints.half); }

/// Values of a column at the step and at half of it, of pairs that have both.
struct ComparedColumn {
  std::vector<double> full, half;
  std::vector<std::size_t> runs;
};

template <class Row>
ComparedColumn compared(const StudyReader& file, const Tables& tables,
                        const TableColumn<Row>& column, const std::vector<Pair>& pairs) {
  const std::vector<double> full = file.numbers(std::string(tables.full) + "/" + column.name);
  const std::vector<double> half = file.numbers(std::string(tables.half) + "/" + column.name);
  ComparedColumn both;
  for (const Pair& pair : pairs) {
    if (column.is_missing(full[pair.full]) || column.is_missing(half[pair.half])) continue;
    both.full.push_back(full[pair.full]);
    both.half.push_back(half[pair.half]);
    both.runs.push_back(pair.run);
  }
  return both;
}

template <class Row>
StepChange change_of(const ComparedColumn& values, const TableColumn<Row>& column,
                     const std::string& point) {
  StepChange change{column.name, point};
  std::vector<double> changes;
  for (std::size_t i = 0; i < values.runs.size(); ++i) {
    const double value =
        std::abs(relative_change(column.name, column.units, values.full[i], values.half[i]));
    if (value > change.largest) {
      change.largest = value;
      change.largest_run = values.runs[i];
    }
    changes.push_back(value);
  }
  change.compared = changes.size();
  if (changes.empty()) return change;
  change.median = statistics::quantile_of(changes, 0.5);
  const auto share = [&](double limit) {
    const auto within = std::ranges::count_if(changes, [&](double each) { return each <= limit; });
    return static_cast<double>(within) / static_cast<double>(changes.size());
  };
  change.within_1_percent = share(0.01);
  change.within_5_percent = share(0.05);
  return change;
}

/// The demands of each marked point by its name, of whatever item.
void add_points(const StudyReader& file, std::vector<Pair> pairs, std::vector<StepChange>& all) {
  const std::vector<std::string> names = file.strings(std::string(kPoints.full) + "/point");
  while (!pairs.empty()) {
    const std::string name = names[pairs.front().full];
    std::vector<Pair> of_point;
    std::erase_if(pairs, [&](const Pair& pair) {
      if (names[pair.full] != name) return false;
      of_point.push_back(pair);
      return true;
    });
    for (const TableColumn<PointDemands>& column : judged_point_columns())
      all.push_back(change_of(compared(file, kPoints, column, of_point), column, name));
  }
}

bool is_kept(const std::vector<LimitState>& states, std::size_t index, bool points) {
  using Of = Quantity::Of;
  const LimitState& state = states[index];
  if (state.kind == LimitState::Kind::kAbove || state.kind == LimitState::Kind::kBelow)
    return state.quantity.of == Of::kItem || (state.quantity.of == Of::kPoint && points);
  return std::ranges::all_of(state.parts,
                             [&](std::size_t part) { return is_kept(states, part, points); });
}

/// Demands of the items of runs, or of their marked points, from a table like /items or /points.
class DemandTable {
 public:
  DemandTable(const StudyReader& file, std::string table)
      : file_(file), table_(std::move(table)), rows_(file.rows_of_runs(table_)) {
    items_ = file.strings(table_ + "/item");
    if (file.has_column(table_ + "/point")) points_ = file.strings(table_ + "/point");
  }

  const Rows& rows() const { return rows_; }

  std::vector<double> values(const Quantity& quantity, std::size_t run) {
    std::vector<double>& column = columns_[quantity.column];
    if (column.empty()) column = file_.numbers(table_ + "/" + quantity.column);
    std::vector<double> values;
    for (std::size_t row = rows_[run].first; row < rows_[run].second; ++row)
      if ((quantity.item.empty() || items_[row] == quantity.item) &&
          (points_.empty() || points_[row] == quantity.part))
        values.push_back(column[row]);
    return values;
  }

 private:
  const StudyReader& file_;
  std::string table_;
  Rows rows_;
  std::vector<std::string> items_, points_;  ///< points: of a table of items empty
  std::map<std::string, std::vector<double>> columns_;
};

/// Values that limit states ask of runs at one step.
class AtStep {
 public:
  AtStep(const StudyReader& file, const char* items, const char* points) : items_(file, items) {
    if (has_points(file)) points_.emplace(file, points);
  }

  const Rows& rows() const { return items_.rows(); }
  const Rows& rows_of_points() const { return points_->rows(); }

  Values of_run(std::size_t run) {
    return [this, run](const Quantity& quantity) {
      return (quantity.of == Quantity::Of::kPoint ? *points_ : items_).values(quantity, run);
    };
  }

 private:
  DemandTable items_;
  std::optional<DemandTable> points_;
};

/// Logarithms of a demand that is above 0 at both steps.
StepDistribution distribution_of(const StudyReader& file, const TableColumn<Demands>& column,
                                 const std::vector<Pair>& pairs,
                                 const std::vector<double>& records) {
  const ComparedColumn values = compared(file, kItems, column, pairs);
  std::vector<statistics::Measured> a, b;
  for (std::size_t i = 0; i < values.runs.size(); ++i) {
    if (!(values.full[i] > 0) || !(values.half[i] > 0)) continue;
    const auto record = static_cast<std::size_t>(records[values.runs[i]]);
    a.push_back({std::log(values.full[i]), record});
    b.push_back({std::log(values.half[i]), record});
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

std::string name_of(const StepChange& change) {
  return change.point.empty() ? change.demand : change.point + ": " + change.demand;
}

std::optional<StepCheck> step_check(const StudyData& data) {
  if (!data.file().has("half_step")) return {};
  AtStep full(data.file(), kItems.full, kPoints.full), half(data.file(), kItems.half, kPoints.half);
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
    if (!has_both(data.file(), kItems, column.name)) continue;
    step_check.changes.push_back(
        change_of(compared(data.file(), kItems, column, pairs), column, ""));
    if (step_check.chaotic)
      step_check.chaotic->demands.push_back(
          distribution_of(data.file(), column, chaotic_pairs, records));
  }
  const bool points = has_points(data.file());
  if (points) {
    std::vector<Pair> of_points = pairs_of(full.rows_of_points(), half.rows_of_points());
    taken(of_points, chaotic, [](const Pair& pair) { return pair.run; });
    add_points(data.file(), std::move(of_points), step_check.changes);
  }
  const std::vector<LimitState>& states = data.limit_states();
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!is_kept(states, i, points)) {
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
