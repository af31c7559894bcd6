#include "studies/analysis/designed_sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/random/sampling.h"
#include "studies/analysis/sensitivity_output.h"
#include "studies/statistics/quantiles.h"

namespace gurney::study {
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
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

/// Quantiles and the tornado of those inputs that are one drawn number, from A and B.
void add_tornado(const ConfigurationView& side, const Design& design, double share,
                 const std::vector<std::optional<std::string>>& variables,
                 StudySensitivity& result) {
  std::vector<std::size_t> draws = design.draw_a;
  draws.insert(draws.end(), design.draw_b.begin(), design.draw_b.end());
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
  StudySensitivity result;
  result.designed = true;
  result.share = request.share;
  result.output = output.name;
  result.units = output.units;
  result.level = output.level;
  result.why_level = output.why_level;
  result.runs = rows * matrices;
  result.left_out = output.left_out + design.left_out;
  result.overturned = output.overturned;
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

}  // namespace gurney::study
