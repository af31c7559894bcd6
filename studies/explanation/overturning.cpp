#include "studies/explanation/overturning.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/units.h"

namespace gurney::explanation {
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

/// Half cycles that end between these times, or go on at `to`.
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

/// Whether histories that the settings ask for have a sample at `time`.
bool asked_for(double time, const SimulationSettings& settings) {
  constexpr double kSame = 1e-6;  // of a spacing
  const double spacing =
      settings.time_step *
      static_cast<double>(std::max(1L, std::lround(settings.history_step / settings.time_step)));
  return settings.history_step > 0 && std::abs(std::remainder(time / spacing, 1)) < kSame;
}

double began_to_tip(const ItemResponse& item, double time, const SimulationSettings& settings) {
  constexpr double kStands = 1 * kRadiansPerDegree;
  double stood = time;
  for (const Sample& sample : item.history)
    if (sample.time < time && sample.tilt < kStands && asked_for(sample.time, settings))
      stood = sample.time;
  return stood;
}

std::vector<Overturning::Liftoff> liftoffs_of(const Demands& demands, const EquipmentModel& item) {
  std::vector<Overturning::Liftoff> result;
  for (std::size_t w = 0; w < demands.wheels.size(); ++w)
    if (demands.wheels[w].liftoff_before_overturning >= 0)
      result.push_back({item.casters.at(w).name, demands.wheels[w].liftoff_before_overturning});
  std::ranges::stable_sort(result, {}, &Overturning::Liftoff::time);
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

std::vector<Overturning> overturnings_of(const study::RunFacts& facts, const Response& response) {
  std::vector<Overturning> result;
  if (is_failure(response.outcome)) return result;
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const Demands& d = response.items[i].demands;
    if (d.lies_from() < 0) continue;
    Overturning found{i,
                      d.time_of_toppling >= 0,
                      d.lies_from(),
                      d.direction_of_overturning,
                      liftoffs_of(d, facts.scene.items.at(i).model),
                      0,
                      {}};
    found.start = found.liftoffs.empty()
                      ? began_to_tip(response.items[i], found.time, facts.settings)
                      : found.liftoffs.front().time;
    if (std::isfinite(found.direction))
      found.half_cycle = driving_half_cycle(
          facts.floor, -Vector2(std::cos(found.direction), std::sin(found.direction)), found.start,
          found.time);
    result.push_back(found);
  }
  return result;
}

}  // namespace gurney::explanation
