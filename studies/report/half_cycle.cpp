#include "studies/report/half_cycle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/units.h"
#include "studies/report/half_cycle_json.h"
#include "studies/report/words.h"

namespace gurney::report {
namespace {

constexpr double kBefore = 2;       // [s]
constexpr double kReversal = 0.2;   // of the range of the velocity
constexpr double kSmallest = 1e-3;  // [m/s]
constexpr double kQuiet = 0.01;     // of the peak acceleration

/// The floor along one direction, at its samples.
struct Component {
  Vector2 direction;
  std::vector<double> time, velocity, acceleration;
};

Component component_of(const FloorMotion& floor, const Vector2& direction, double from, double to) {
  Component result{direction, {}, {}, {}};
  const double step = floor.time_step();
  const auto first = static_cast<long>(std::ceil(std::max(from, 0.0) / step));
  for (long i = first; static_cast<double>(i) * step <= to; ++i) {
    const double time = static_cast<double>(i) * step;
    result.time.push_back(time);
    result.velocity.push_back(direction.dot(floor.velocity_at(time).head<2>()));
    result.acceleration.push_back(direction.dot(floor.acceleration_at(time).head<2>()));
  }
  return result;
}

struct Rise {
  std::size_t from = 0, to = 0;
};

/// From turning point to turning point.
std::vector<Rise> rises_of(const std::vector<double>& velocity, double reversal) {
  std::vector<Rise> rises;
  Rise rise;
  std::size_t lowest = 0;
  bool rising = false;
  for (std::size_t i = 1; i < velocity.size(); ++i) {
    if (rising) {
      if (velocity[i] > velocity[rise.to]) rise.to = i;
      if (velocity[rise.to] - velocity[i] <= reversal) continue;
      rises.push_back(rise);
      rising = false;
      lowest = i;
    } else {
      if (velocity[i] < velocity[lowest]) lowest = i;
      if (velocity[i] - velocity[lowest] <= reversal) continue;
      rise = {lowest, i};
      rising = true;
    }
  }
  if (rising) rises.push_back(rise);
  return rises;
}

HalfCycle half_cycle_of(const Component& along, Rise rise) {
  const auto from = along.acceleration.begin();
  const auto peak =
      std::max_element(from + static_cast<long>(rise.from), from + static_cast<long>(rise.to) + 1);
  const auto top = static_cast<std::size_t>(peak - from);
  while (rise.from + 1 < top && along.acceleration[rise.from + 1] <= kQuiet * *peak) ++rise.from;
  while (rise.to > top + 1 && along.acceleration[rise.to - 1] <= kQuiet * *peak) --rise.to;
  HalfCycle result{along.direction,
                   along.time[rise.from],
                   along.time[rise.to],
                   along.velocity[rise.to] - along.velocity[rise.from],
                   0,
                   *peak,
                   along.time[top]};
  for (std::size_t i = rise.from; i <= rise.to; ++i)
    result.peak_velocity = std::max(result.peak_velocity, std::abs(along.velocity[i]));
  return result;
}

/// Of those that end between these times, or go on at `to`.
std::optional<HalfCycle> largest(const FloorMotion& floor, const Vector2& direction, double from,
                                 double to) {
  const Component along = component_of(floor, direction, from - kBefore, to);
  if (along.time.empty()) return {};
  const auto [low, high] = std::ranges::minmax(along.velocity);
  if (high - low < kSmallest) return {};
  std::optional<HalfCycle> result;
  for (const Rise& rise : rises_of(along.velocity, kReversal * (high - low))) {
    if (along.time[rise.to] < from) continue;
    const HalfCycle each = half_cycle_of(along, rise);
    if (!result || each.velocity_change > result->velocity_change) result = each;
  }
  return result;
}

}  // namespace

std::optional<HalfCycle> driving_half_cycle(const FloorMotion& floor, const Vector2& direction,
                                            double from, double to) {
  if (floor.at_rest()) return {};
  if (to > from)
    if (const auto during = largest(floor, direction, from, to)) return during;
  return largest(floor, direction, from - kLookBack, to);
}

std::string sentence(const HalfCycle& of, const study::UnitSystem& units) {
  const double peak = of.peak_acceleration;
  const std::string up_to =
      units.chosen() ? units.text(peak, "m/s2") + " ("
                     : fmt::format("{:.3g} m/s2 ({:.2f} g, ", peak, peak / kStandardGravity);
  return fmt::format(
      "A half cycle of the floor's motion {} drove it, opposite to the motion of the item, from "
      "{:.2f} s to {:.2f} s: {:.2f} s long, up to {}at {:.2f} s) and {}; it changed the floor's "
      "velocity by {}.",
      towards(std::atan2(of.direction.y(), of.direction.x()), units), of.start, of.end,
      of.end - of.start, up_to, of.time_of_peak, units.text(of.peak_velocity, "m/s"),
      units.text(of.velocity_change, "m/s"));
}

nlohmann::ordered_json half_cycle_json(const std::optional<HalfCycle>& of) {
  if (!of) return nullptr;
  return {{"direction_rad", std::atan2(of->direction.y(), of->direction.x())},
          {"start_s", of->start},
          {"end_s", of->end},
          {"duration_s", of->end - of->start},
          {"peak_acceleration_m_per_s2", of->peak_acceleration},
          {"time_of_peak_s", of->time_of_peak},
          {"peak_velocity_m_per_s", of->peak_velocity},
          {"velocity_change_m_per_s", of->velocity_change}};
}

}  // namespace gurney::report
