#include "studies/analysis/study_sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "engine/base/error.h"
#include "studies/analysis/designed_sensitivity.h"
#include "studies/analysis/replica_cases.h"
#include "studies/analysis/sensitivity_output.h"
#include "studies/statistics/quantiles.h"

namespace gurney::study {
namespace {

constexpr double kWeak = 0.3;          // a tenth of the variance in common
constexpr double kBeyondChance = 3.5;  // standard deviations: of 80 pairs one in 25 times

/// Adds the drawn numbers: constant ones apart, those with equal values together.
std::vector<std::vector<double>> add_drawn(const DrawnNumbers& drawn,
                                           const std::vector<std::size_t>& draws,
                                           StudySensitivity& result) {
  std::vector<std::vector<double>> columns;
  for (const std::string& name : drawn.names) {
    const std::vector<double> column = drawn.column(name, draws);
    if (std::ranges::all_of(column, [&](double value) { return value == column.front(); })) {
      result.constant.push_back(name);
      continue;
    }
    const auto same = std::ranges::find(columns, column);
    if (same != columns.end()) {
      result.inputs[static_cast<std::size_t>(same - columns.begin())].names.push_back(name);
      continue;
    }
    columns.push_back(column);
    result.inputs.push_back({.names = {name}, .set = 0});
  }
  return columns;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const statistics::Moments of_a = statistics::moments_of(a), of_b = statistics::moments_of(b);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - of_a.mean) * (b[i] - of_b.mean);
  return sum / (static_cast<double>(a.size() - 1) * std::sqrt(of_a.variance * of_b.variance));
}

/// Puts inputs whose ranks are correlated into one set. Without correlation the coefficient has a
/// standard deviation of 1 / sqrt(n - 1) (Kendall 1948, Rank correlation methods).
void find_sets(const std::vector<std::vector<double>>& columns, StudySensitivity& result) {
  std::vector<std::vector<double>> ranks;
  for (const auto& column : columns) ranks.push_back(statistics::ranks_of(column));
  const double freedom = static_cast<double>(std::max<std::size_t>(result.draws, 2)) - 1;
  const double limit = std::max(kWeak, kBeyondChance / std::sqrt(freedom));
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    result.inputs[i].set = i;
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(correlation(ranks[i], ranks[j])) > limit) {
        const std::size_t from = result.inputs[j].set, to = result.inputs[i].set;
        for (std::size_t k = 0; k <= i; ++k)
          if (result.inputs[k].set == from) result.inputs[k].set = to;
      }
  }
  std::map<std::size_t, std::vector<std::string>> sets;
  for (const SensitiveInput& input : result.inputs) sets[input.set].push_back(input.names.front());
  for (const auto& [set, names] : sets)
    if (names.size() > 1) result.correlated.push_back(names);
}

/// Adds what runs differ by besides their draws; the record only where it has several draws.
void add_classes(const char* name, const std::vector<double>& values, const std::vector<double>& y,
                 StudySensitivity& result) {
  std::map<double, std::size_t> number;
  std::vector<std::size_t> classes;
  for (const double value : values)
    classes.push_back(number.try_emplace(value, number.size()).first->second);
  if (number.size() < 2) return;
  result.inputs.push_back({.names = {name}, .set = result.inputs.size(), .drawn = false});
  result.inputs.back().index = statistics::first_order_index_of_classes(classes, y);
}

/// What is left of the variance where everything is given but the replica.
void add_chaos(const StudyReader& file, const SensitivityOutput& output, StudySensitivity& result) {
  if (!has_replicas(file)) return;
  const std::vector<std::size_t> cases = replica_cases(file);
  std::vector<std::size_t> classes;
  for (const std::size_t run : output.runs) classes.push_back(cases[run]);
  result.inputs.push_back({.names = {kChaos}, .set = result.inputs.size(), .drawn = false});
  result.inputs.back().index = statistics::share_within_classes(classes, output.values);
}

std::vector<double> picked(const std::vector<double>& all, const std::vector<std::size_t>& runs) {
  std::vector<double> result;
  for (const std::size_t run : runs) result.push_back(all[run]);
  return result;
}

}  // namespace

statistics::TornadoBar stated_bar(statistics::TornadoBar bar) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  if (bar.low_runs < kFewestOfMean) bar.low = bar.low_error = kUnknown;
  if (bar.high_runs < kFewestOfMean) bar.high = bar.high_error = kUnknown;
  return bar;
}

StudySensitivity study_sensitivity(const ConfigurationView& side,
                                   const SensitivityRequest& request) {
  const StudyData& data = *side.data;
  const StudyReader& file = data.file();
  require(file.has("drawn"), file.path() +
                                 ": the study drew no numbers (study.draws), so there is "
                                 "nothing whose influence could be estimated");
  if (!design_inputs(data).empty()) return designed_sensitivity(side, request);
  const SensitivityOutput output = sensitivity_output(side, request);
  require_variation(output, file.path());
  const std::vector<std::size_t>& runs = output.runs;
  const std::vector<double>& y = output.values;
  const statistics::Moments moments = statistics::moments_of(y);
  StudySensitivity result;
  result.share = request.share;
  result.output = output.name;
  result.units = output.units;
  result.level = output.level;
  result.why_level = output.why_level;
  result.runs = runs.size();
  result.left_out = output.left_out;
  result.overturned = output.overturned;
  result.mean = moments.mean;
  result.deviation = std::sqrt(moments.variance);
  result.draws = std::set<std::size_t>(output.draw.begin(), output.draw.end()).size();
  result.repeated_draws = result.draws < result.runs;
  const auto columns = add_drawn(drawn_numbers(side), output.draw, result);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    result.inputs[i].index = statistics::first_order_index(columns[i], y);
    result.inputs[i].low = statistics::quantile_of(columns[i], request.share);
    result.inputs[i].high = statistics::quantile_of(columns[i], 1 - request.share);
  }
  for (const statistics::TornadoBar& bar : statistics::tornado(columns, y, request.share))
    result.inputs[bar.input].bar = stated_bar(bar);
  find_sets(columns, result);
  const Levels levels(data);
  std::vector<double> level;
  for (const std::size_t run : runs) level.push_back(static_cast<double>(levels.of_run(run)));
  add_classes("record", picked(file.numbers("runs/record"), runs), y, result);
  add_classes("angle", picked(file.numbers("runs/angle"), runs), y, result);
  add_classes("level", level, y, result);
  add_chaos(file, output, result);
  std::map<std::size_t, double> largest;
  for (const SensitiveInput& input : result.inputs) {
    if (!input.index) continue;
    const auto known = largest.try_emplace(input.set, input.index->estimate).first;
    known->second = std::max(known->second, input.index->estimate);
  }
  for (const auto& [set, index] : largest) result.sum += index;
  std::ranges::stable_sort(result.inputs, [](const SensitiveInput& a, const SensitiveInput& b) {
    return (a.index ? a.index->estimate : -1) > (b.index ? b.index->estimate : -1);
  });
  return result;
}

}  // namespace gurney::study
