#include "studies/page/calibration_facts.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace gurney::page {
namespace {

FittedConstant constant_of(const JsonValue& of, const std::vector<JsonValue>& values) {
  FittedConstant result{.about = of.text("constant"),
                        .name = of.text("name"),
                        .unit = of.text("unit"),
                        .caster = of.text("caster"),
                        .floor = of.text("floor"),
                        .value = of.number("value"),
                        .scatter = of.number("scatter_of_logarithm"),
                        .lower_bound = of.flag("lower_bound"),
                        .interval = ends_in(of, "interval_95"),
                        .prediction = ends_in(of, "prediction_95"),
                        .degrees = of.count("degrees"),
                        .used = of.texts("trials").size(),
                        .trials = {}};
  for (const JsonValue& each : values)
    if (each.text("constant") == result.about && each.flag("lower_bound") == result.lower_bound)
      result.trials.push_back({each.text("trial"), each.text("use") == "validation",
                               each.number("value"), each.number("standard_error")});
  return result;
}

}  // namespace

Ends ends_in(const JsonValue& of, const std::string& key) {
  const std::vector<double> ends = of.numbers(key);
  if (ends.size() != 2) of.at(key).refuse("must be two numbers");
  constexpr double kNone = std::numeric_limits<double>::infinity();
  return {std::isnan(ends[0]) ? -kNone : ends[0], std::isnan(ends[1]) ? kNone : ends[1]};
}

bool Ends::bounded() const { return std::isfinite(low) && std::isfinite(high); }

std::string Ends::text() const {
  if (bounded()) return fmt::format("{:.4g} to {:.4g}", low, high);
  return std::isfinite(low) && low > 0 ? fmt::format("{:.4g} or more", low) : "none";
}

double FittedConstant::standardised(const FittedTrial& trial) const {
  return std::log(trial.value / value) / std::hypot(scatter, trial.error / trial.value);
}

std::vector<FittedConstant> constants_in(const JsonValue& calibration) {
  const std::vector<JsonValue> values = calibration.objects("values");
  std::vector<FittedConstant> constants;
  for (const JsonValue& each : calibration.objects("constants"))
    constants.push_back(constant_of(each, values));
  return constants;
}

}  // namespace gurney::page
