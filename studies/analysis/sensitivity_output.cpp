#include "studies/analysis/sensitivity_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/base/error.h"
#include "engine/response/response.h"
#include "studies/analysis/demands.h"
#include "studies/analysis/fitted_curve.h"
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
  const std::size_t count = levels.values().size();
  if (request.level) return request.level;
  if (request.all_levels || count < 2 || count > kMaxLevels ||
      data.study().intensity.kind == IntensityPlan::Kind::kIda)
    return {};
  const auto median = median_near(side, request);
  if (!median) {
    output.why_level =
        "the middle one, as no limit state has a curve; --level and --all-levels "
        "choose others";
    return count / 2;
  }
  const auto distance = [&](double im) { return std::abs(std::log(im / median->second)); };
  const auto nearest = std::ranges::min_element(levels.values(), {}, distance);
  output.why_level = fmt::format(
      "nearest to the median of '{}'; --level and --all-levels choose "
      "others",
      median->first);
  return static_cast<std::size_t>(nearest - levels.values().begin());
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

}  // namespace gurney::study
