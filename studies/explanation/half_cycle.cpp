#include "studies/explanation/half_cycle.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gurney::explanation {
namespace {

constexpr double kBefore = 2;       // [s]
constexpr double kReversal = 0.2;   // of the range of the velocity
constexpr double kSmallest = 1e-3;  // [m/s]
constexpr double kQuiet = 0.01;     // of the peak acceleration

/// The floor along one direction, at its samples.
struct Component {
  std::vector<double> time, velocity, acceleration;
};

Component component_of(const FloorMotion& floor, const Vector2& direction, double from, double to) {
  Component result;
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

report::FloorPulse pulse_of(const Component& along, Rise rise) {
  const auto from = along.acceleration.begin();
  const auto peak =
      std::max_element(from + static_cast<long>(rise.from), from + static_cast<long>(rise.to) + 1);
  const auto top = static_cast<std::size_t>(peak - from);
  while (rise.from + 1 < top && along.acceleration[rise.from + 1] <= kQuiet * *peak) ++rise.from;
  while (rise.to > top + 1 && along.acceleration[rise.to - 1] <= kQuiet * *peak) --rise.to;
  return {along.time[rise.from], along.time[rise.to],
          along.velocity[rise.to] - along.velocity[rise.from], *peak, along.time[top]};
}

}  // namespace

std::optional<report::FloorPulse> driving_half_cycle(const FloorMotion& floor,
                                                     const Vector2& direction, double from,
                                                     double to) {
  if (floor.at_rest() || !(to > from)) return {};
  const Component along = component_of(floor, direction, from - kBefore, to);
  if (along.time.empty()) return {};
  const auto [low, high] = std::ranges::minmax(along.velocity);
  if (high - low < kSmallest) return {};
  std::optional<report::FloorPulse> largest;
  for (const Rise& rise : rises_of(along.velocity, kReversal * (high - low))) {
    if (along.time[rise.to] < from) continue;
    const report::FloorPulse pulse = pulse_of(along, rise);
    if (!largest || pulse.velocity_change > largest->velocity_change) largest = pulse;
  }
  return largest;
}

}  // namespace gurney::explanation
