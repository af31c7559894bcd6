#include "studies/analysis/study_sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/base/random/sampling.h"
#include "engine/response/response.h"
#include "studies/analysis/demands.h"
#include "studies/analysis/fitted_curve.h"
#include "studies/analysis/replica_spread.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/statistics/quantiles.h"

namespace gurney::study {
namespace {

constexpr std::size_t kMaxLevels = 40;  // more intensities are a cloud

std::vector<std::size_t> runs_at(const ConfigurationView& side, const Levels& levels,
                                 const std::optional<std::size_t>& level) {
  if (!level) return side.runs();
  std::vector<std::size_t> runs;
  for (const std::size_t run : side.runs())
    if (levels.of_run(run) == *level) runs.push_back(run);
  return runs;
}

/// The limit state whose median a level is chosen by: that asked for, or of the demand asked for,
/// else the first with a curve.
std::optional<std::pair<std::string, double>> median_near(const ConfigurationView& side,
                                                          const SensitivityRequest& request) {
  const StudyData& data = *side.data;
  std::optional<std::pair<std::string, double>> first;
  for (std::size_t i = 0; i < data.limit_states().size(); ++i) {
    const LimitState& state = data.limit_states()[i];
    const bool asked = request.limit.empty() ? state.quantity.column == request.demand
                                             : state.name == request.limit;
    if (first && !asked) continue;
    const auto curve = fitted_curve(data, i, side.configuration, data.measure("")).curve();
    if (curve && (asked || !first)) first = {state.name, curve->theta};
    if (curve && asked) return first;
  }
  return first;
}

/// Levels together would mostly show that stronger motions move items farther.
std::optional<std::size_t> level_of(const ConfigurationView& side, const Levels& levels,
                                    const SensitivityRequest& request, SensitivityOutput& output) {
  const StudyData& data = *side.data;
  if (request.level) return request.level;
  require(!request.all_levels || !data.has_suites_by_level(),
          data.file().path() +
              ": each level has records of its own, so that the influence of the record at all "
              "levels would be that of the level; take one by --level");
  std::set<std::size_t> own;  // stages that are planned for each configuration have other levels
  for (const std::size_t run : side.runs()) own.insert(levels.of_run(run));
  if (request.all_levels || own.size() < 2 || own.size() > kMaxLevels ||
      data.study().intensity.kind == IntensityPlan::Kind::kIda)
    return {};
  const auto median = median_near(side, request);
  if (!median) {
    output.why_level =
        "the middle one, as no limit state has a curve; --level and --all-levels "
        "choose others";
    return *std::next(own.begin(), static_cast<std::ptrdiff_t>(own.size() / 2));
  }
  const auto distance = [&](std::size_t level) {
    return std::abs(std::log(levels.values()[level] / median->second));
  };
  output.why_level = fmt::format(
      "nearest to the median of '{}'; --level and --all-levels choose "
      "others",
      median->first);
  return *std::ranges::min_element(own, {}, distance);
}

std::vector<double> values_of(const ConfigurationView& side, const SensitivityRequest& request,
                              const std::vector<std::size_t>& runs, SensitivityOutput& output) {
  const StudyData& data = *side.data;
  if (!request.limit.empty()) {
    output.name = "exceedance of " + request.limit;
    output.units = "1";
    std::vector<double> values;
    for (const bool exceeds : data.exceedances(index_of(data.limit_states(), request.limit), runs))
      values.push_back(exceeds);
    return values;
  }
  const auto demands = demands_named(data, side.configuration, {request.demand});
  std::vector<std::string> names;
  for (const NamedDemand& each : demands) names.push_back("'" + each.name + "'");
  require(demands.size() == 1,
          fmt::format("{}: several items have a demand '{}'; name one: {}", data.file().path(),
                      request.demand, fmt::join(names, ", ")));
  output.name = demands[0].name;
  output.units = demands[0].units;
  return values_of_runs(data, demands[0], runs);
}

}  // namespace

SensitivityOutput sensitivity_output(const ConfigurationView& side,
                                     const SensitivityRequest& request) {
  const StudyData& data = *side.data;
  const Levels levels(data);
  require(!request.level || *request.level < levels.values().size(),
          fmt::format("{}: has no level {}; it has 1 to {}", data.file().path(),
                      request.level.value_or(0) + 1, levels.values().size()));
  SensitivityOutput output;
  const std::optional<std::size_t> level = level_of(side, levels, request, output);
  if (level) output.level = levels.name_of(*level);
  const std::vector<std::size_t> runs = runs_at(side, levels, level);
  const std::vector<double> values = values_of(side, request, runs, output);
  const std::vector<std::string> outcomes = data.file().strings("runs/outcome");
  const std::vector<double> draws = data.file().numbers("runs/draw");
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (std::isnan(values[i])) {
      ++output.left_out;
      continue;
    }
    output.runs.push_back(runs[i]);
    output.values.push_back(values[i]);
    output.draw.push_back(static_cast<std::size_t>(draws[runs[i]]));
    output.overturned += outcomes[runs[i]] == name_of(Outcome::kOverturned);
  }
  return output;
}

void require_variation(const SensitivityOutput& output, const std::string& file) {
  const std::string at = output.level.empty() ? "" : " at " + output.level;
  const std::string others = output.level.empty() ? "" : "; --level N and --all-levels take others";
  require(output.runs.size() >= kFewestRuns,
          fmt::format("{}: {} runs of {}{} are too few: at least {} are needed, and 100 or more "
                      "give informative intervals{}",
                      file, output.runs.size(), output.name, at, kFewestRuns, others));
  require(statistics::moments_of(output.values).variance > 0,
          fmt::format("{}: {} is {:g} in every run{}: no input controls it{}", file, output.name,
                      output.values.front(), at, others));
}

std::vector<double> DrawnNumbers::column(const std::string& name,
                                         const std::vector<std::size_t>& draws) const {
  std::vector<double> column;
  const auto& of_draw = values.at(name);
  for (const std::size_t draw : draws) {
    const auto value = of_draw.find(draw);
    require(value != of_draw.end(), fmt::format("/drawn has no {} of draw {}", name, draw));
    column.push_back(value->second);
  }
  return column;
}

DrawnNumbers drawn_numbers(const ConfigurationView& side) {
  const StudyReader& file = side.data->file();
  const auto configuration = file.numbers("drawn/configuration"), draw = file.numbers("drawn/draw"),
             value = file.numbers("drawn/value");
  const auto variable = file.strings("drawn/variable");
  DrawnNumbers drawn;
  for (std::size_t row = 0; row < value.size(); ++row) {
    if (static_cast<std::size_t>(configuration[row]) != side.configuration) continue;
    auto& values = drawn.values[variable[row]];
    if (values.empty()) drawn.names.push_back(variable[row]);
    values[static_cast<std::size_t>(draw[row])] = value[row];
  }
  return drawn;
}

namespace {

/// Outputs of the matrices, a row for each point under each angle and level.
struct Design {
  std::vector<std::vector<double>> outputs;  ///< of each matrix
  std::vector<std::size_t> draw_a, draw_b;   ///< of each row
  std::vector<std::size_t> scene;            ///< of each row: angle and level
  std::size_t left_out = 0;                  ///< runs of points that are not whole
};

Design design_of(const ConfigurationView& side, const SensitivityOutput& output,
                 std::size_t matrices) {
  const Levels levels(*side.data);
  const std::vector<double> angle = side.data->file().numbers("runs/angle");
  using Scene = std::pair<double, std::size_t>;
  std::map<Scene, std::map<std::size_t, std::map<std::size_t, std::size_t>>> places;
  for (std::size_t i = 0; i < output.runs.size(); ++i) {
    const std::size_t run = output.runs[i], draw = output.draw[i];
    places[{angle[run], levels.of_run(run)}][draw / matrices][draw % matrices] = i;
  }
  Design design;
  design.outputs.resize(matrices);
  std::size_t scene = 0;
  for (const auto& [of_scene, points] : places) {
    for (const auto& [point, rows] : points) {
      if (rows.size() < matrices) {
        design.left_out += rows.size();
        continue;
      }
      for (const auto& [matrix, i] : rows) design.outputs[matrix].push_back(output.values[i]);
      design.draw_a.push_back(output.draw[rows.at(0)]);
      design.draw_b.push_back(output.draw[rows.at(1)]);
      design.scene.push_back(scene);
    }
    ++scene;
  }
  return design;
}

/// Takes off the mean of A and B under each angle and level.
void take_off_means(Design& design) {
  std::map<std::size_t, std::pair<double, double>> sums;
  for (std::size_t row = 0; row < design.scene.size(); ++row) {
    auto& [sum, count] = sums[design.scene[row]];
    sum += design.outputs[0][row] + design.outputs[1][row];
    count += 2;
  }
  for (auto& outputs : design.outputs)
    for (std::size_t row = 0; row < outputs.size(); ++row) {
      const auto& [sum, count] = sums[design.scene[row]];
      outputs[row] -= sum / count;
    }
}

std::vector<double> joined(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> all = a;
  append_all(all, b);
  return all;
}

/// Quantiles and the tornado of those inputs that are one drawn number, from A and B.
void add_tornado(const ConfigurationView& side, const Design& design, double share,
                 const std::vector<std::optional<std::string>>& variables,
                 StudySensitivity& result) {
  std::vector<std::size_t> draws = design.draw_a;
  append_all(draws, design.draw_b);
  const std::vector<double> y = joined(design.outputs[0], design.outputs[1]);
  const DrawnNumbers drawn = drawn_numbers(side);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    SensitiveInput& input = result.inputs[i];
    input.drawn = variables[i] && drawn.values.contains(*variables[i]);
    if (!input.drawn) continue;
    const std::vector<double> column = drawn.column(*variables[i], draws);
    input.low = statistics::quantile_of(column, share);
    input.high = statistics::quantile_of(column, 1 - share);
    input.bar = stated_bar(statistics::tornado({column}, y, share).front());
    input.bar.low += result.mean;
    input.bar.high += result.mean;
  }
}

}  // namespace

std::vector<std::string> design_inputs(const StudyData& data) {
  if (data.study().sampling != Sampling::kSaltelli) return {};
  return data.file().strings("design/input");
}

/// The facts of an analysis that its output gives.
StudySensitivity begun(const SensitivityOutput& output, const SensitivityRequest& request) {
  StudySensitivity result;
  result.share = request.share;
  result.output = output.name;
  result.units = output.units;
  result.level = output.level;
  result.why_level = output.why_level;
  result.runs = output.runs.size();
  result.left_out = output.left_out;
  result.overturned = output.overturned;
  return result;
}

StudySensitivity designed_sensitivity(const ConfigurationView& side,
                                      const SensitivityRequest& request) {
  constexpr std::string_view kVariable = "variable ";
  const std::string& file = side.data->file().path();
  const std::vector<std::string> inputs = design_inputs(*side.data);
  const std::size_t matrices = kSaltelliMatrices + inputs.size();
  const SensitivityOutput output = sensitivity_output(side, request);
  require_variation(output, file);
  Design design = design_of(side, output, matrices);
  const std::size_t rows = design.scene.size();
  require(rows >= kFewestRuns,
          fmt::format("{}: {} points with all {} runs of {} are too few: at least {} are needed, "
                      "and 500 or more give informative intervals",
                      file, rows, matrices, output.name, kFewestRuns));
  StudySensitivity result = begun(output, request);
  result.designed = true;
  result.runs = rows * matrices;
  result.left_out += design.left_out;
  result.draws = std::set<std::size_t>(design.draw_a.begin(), design.draw_a.end()).size();
  result.repeated_draws = result.draws < rows;
  result.mean = statistics::moments_of(joined(design.outputs[0], design.outputs[1])).mean;
  take_off_means(design);
  result.deviation =
      std::sqrt(statistics::moments_of(joined(design.outputs[0], design.outputs[1])).variance);

  const std::vector<std::vector<double>> mixed(design.outputs.begin() + kSaltelliMatrices,
                                               design.outputs.end());
  const auto indices = statistics::sobol_indices(design.outputs[0], design.outputs[1], mixed);
  require(!indices.empty(), fmt::format("{}: {} is {:g} in every run of the matrices A and B: "
                                        "no input controls it",
                                        file, output.name, result.mean));
  std::vector<std::optional<std::string>> variables;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const bool variable = inputs[i].starts_with(kVariable);
    const std::string name = variable ? inputs[i].substr(kVariable.size()) : inputs[i];
    variables.push_back(variable ? std::optional(name) : std::nullopt);
    result.inputs.push_back(
        {.names = {name}, .set = i, .index = indices[i].first, .total = indices[i].total});
    result.sum += indices[i].first.estimate;
  }
  add_tornado(side, design, request.share, variables, result);
  std::ranges::stable_sort(result.inputs, [](const SensitiveInput& a, const SensitiveInput& b) {
    return a.total->estimate > b.total->estimate;
  });
  return result;
}

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

/// Adds the variance that is left where everything is given but the replica.
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
  StudySensitivity result = begun(output, request);
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
