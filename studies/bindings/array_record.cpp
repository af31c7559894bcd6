#include "studies/bindings/array_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/record/record.h"

namespace gurney::bindings {
namespace {

using groundmotions::Direction;

void check(std::span<const double> samples, std::size_t columns, double time_step) {
  require(columns == 1 || columns == 3,
          fmt::format("record: has {} columns; must have 1 (x) or 3 (x, y, z), and a row for each "
                      "time",
                      columns));
  require(samples.size() >= 2 * columns,
          fmt::format("record: has {} samples; must have 2 or more", samples.size() / columns));
  require(groundmotions::is_time_step(time_step),
          fmt::format("time_step = {:g}: must be in [{:g}, {:g}] s", time_step,
                      groundmotions::kShortestTimeStep, groundmotions::kLongestTimeStep));
  const auto bad = std::ranges::find_if_not(samples, [](double a) { return std::isfinite(a); });
  const auto index = static_cast<std::size_t>(bad - samples.begin());
  require(bad == samples.end(), fmt::format("record: sample {}, column {} is not a finite number",
                                            index / columns, index % columns));
  constexpr double kLargest = 100 * kStandardGravity;  // of a record file too
  const auto large = std::ranges::find_if(samples, [](double a) { return std::abs(a) > kLargest; });
  const auto at = static_cast<std::size_t>(large - samples.begin());
  require(large == samples.end(),
          fmt::format("record: sample {}, column {} is {:g} m/s2; at most {:g} m/s2 (100 g) are "
                      "allowed: check the unit",
                      at / columns, at % columns, large == samples.end() ? 0 : *large, kLargest));
}

}  // namespace

groundmotions::Record array_record(std::span<const double> samples, std::size_t columns,
                                   double time_step) {
  check(samples, columns, time_step);
  static constexpr const char* kNames[] = {"x", "y", "z"};
  groundmotions::Record record;
  record.name = "array";
  for (std::size_t column = 0; column < columns; ++column) {
    groundmotions::Component& component = record.components[column].emplace();
    component.name = kNames[column];
    component.time_step = time_step;
    component.direction = static_cast<Direction>(column);
    component.unit = "m/s2";
    component.acceleration.resize(static_cast<Eigen::Index>(samples.size() / columns));
    for (Eigen::Index row = 0; row < component.acceleration.size(); ++row)
      component.acceleration[row] = samples[static_cast<std::size_t>(row) * columns + column];
  }
  return record;
}

}  // namespace gurney::bindings
