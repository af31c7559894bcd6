#include "studies/job/scale_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/base/error.h"
#include "engine/base/units.h"

namespace gurney {
namespace {

using config::Range;
using config::Table;

struct Unit {
  const char* name;
  const char* si;  ///< unit of the measures it is for
  double to_si;
};
constexpr std::array kUnits = {Unit{"g", "m/s2", kStandardGravity},
                               Unit{"m/s2", "m/s2", 1},
                               Unit{"cm/s2", "m/s2", 0.01},
                               Unit{"m/s", "m/s", 1},
                               Unit{"cm/s", "m/s", 0.01},
                               Unit{"m", "m", 1},
                               Unit{"cm", "m", 0.01}};

Measure read_measure(Table& in) {
  try {
    return parse_measure(in.text("measure"));
  } catch (const Error& error) {
    in.note("measure", std::string(": ") + error.what());
    return {};
  }
}

Combination read_combination(Table& in, const Measure& measure) {
  const auto names = known_combinations();
  const auto usual = std::ranges::find(names, name_of(Combination::kGeometricMean));
  const Combination combination = parse_combination(
      names[in.choice("component", names, static_cast<std::size_t>(usual - names.begin()))]);
  if (combination == Combination::kResultant && !has_resultant(measure))
    in.note("component", ": " + name_of(measure) + " has no resultant; PGA, PGV and PGD have");
  return combination;
}

/// Factor from the unit of `unit` to SI.
double read_unit(Table& in, const std::string& si) {
  std::vector<std::string> allowed;
  std::vector<double> factors;
  for (const Unit& unit : kUnits)
    if (si == unit.si) {
      allowed.push_back(unit.name);
      factors.push_back(unit.to_si);
    }
  if (!allowed.empty()) return factors[in.choice("unit", allowed)];
  in.has("unit");
  in.note("measure", ": a record cannot be scaled to a measure in " + si);
  return 1;
}

}  // namespace

ScaleTo read_scale_to(Table& in) {
  ScaleTo request;
  request.measure = read_measure(in);
  request.combination = read_combination(in, request.measure);
  const double factor = read_unit(in, si_unit_of(request.measure));
  request.value = in.number("value", Range::positive()) * factor;
  request.vertical.rule =
      static_cast<VerticalScaling::Rule>(in.choice("vertical", {"alike", "kept"}, std::size_t{0}));
  return request;
}

Record scaled_to(const Record& record, const ScaleTo& request) {
  const ScalingMeasure measure{
      fmt::format("{} ({}) [{}]", name_of(request.measure), name_of(request.combination),
                  si_unit_of(request.measure)),
      [&](const Record& scaled) { return value_of(request.measure, request.combination, scaled); },
      scaling_power(request.measure)};
  return scale_to(record, measure, request.value, request.vertical);
}

}  // namespace gurney
