#include "studies/job/scale_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"
#include "engine/base/unit_table.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

void read_unit(Table& in, ScalingTarget& target) {
  const std::string si = groundmotions::si_unit_of(target.measure);
  const std::vector<std::string> allowed = units_in_files(si);
  if (allowed.empty() || groundmotions::scaling_power(target.measure) == 0) {
    in.has("unit");
    in.note("measure", ": a record cannot be scaled to a measure in " + si);
    return;
  }
  target.unit = allowed[in.choice("unit", allowed)];
  target.unit_in_si = in_si(target.unit);
}

}  // namespace

groundmotions::Measure read_measure(Table& in) {
  try {
    return groundmotions::parse_measure(in.text("measure"));
  } catch (const Error& error) {
    in.note("measure", std::string(": ") + error.what());
    return {};
  }
}

groundmotions::Combination read_combination(Table& in, const groundmotions::Measure& measure) {
  const auto names = groundmotions::known_combinations();
  const auto usual = std::ranges::find(names, name_of(groundmotions::Combination::kGeometricMean));
  const groundmotions::Combination combination = groundmotions::parse_combination(
      names[in.choice("component", names, static_cast<std::size_t>(usual - names.begin()))]);
  if (combination == groundmotions::Combination::kResultant &&
      !groundmotions::has_resultant(measure))
    in.note("component", ": " + name_of(measure) + " has no resultant; PGA, PGV and PGD have");
  return combination;
}

ScalingTarget read_scaling_target(Table& in) {
  ScalingTarget target;
  target.measure = read_measure(in);
  target.combination = read_combination(in, target.measure);
  read_unit(in, target);
  return target;
}

groundmotions::VerticalScaling read_vertical_scaling(Table& in) {
  groundmotions::VerticalScaling vertical;
  vertical.rule = static_cast<groundmotions::VerticalScaling::Rule>(
      in.choice("vertical", {"alike", "kept"}, std::size_t{0}));
  return vertical;
}

ScaleTo read_scale_to(Table& in) {
  const ScalingTarget target = read_scaling_target(in);
  return {.measure = target.measure,
          .combination = target.combination,
          .value = in.number("value", Range::positive()) * target.unit_in_si,
          .vertical = read_vertical_scaling(in)};
}

groundmotions::ScalingMeasure scaling_measure(const groundmotions::Measure& measure,
                                              groundmotions::Combination combination) {
  return {
      fmt::format("{} ({}) [{}]", name_of(measure), name_of(combination),
                  groundmotions::si_unit_of(measure)),
      [=](const groundmotions::Record& scaled) { return value_of(measure, combination, scaled); },
      groundmotions::scaling_power(measure)};
}

groundmotions::Record scaled_to(const groundmotions::Record& record, const ScaleTo& request) {
  return groundmotions::scale_to(record, scaling_measure(request.measure, request.combination),
                                 request.value, request.vertical);
}

}  // namespace gurney::study
