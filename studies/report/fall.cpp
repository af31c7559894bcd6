#include "studies/report/fall.h"

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"

namespace gurney::report {
namespace {

constexpr double kNoPulse = 1e-3;  // [m/s]
constexpr double kNoise = 1e-6;    // of a velocity that stays [m/s]

/// The last sample before `time` in which the item stood; without one, `time`.
double began_to_tip(const ItemResponse& item, double time) {
  constexpr double kStands = 1 * kRadiansPerDegree;
  double stood = time;
  for (const Sample& sample : item.history)
    if (sample.time < time && sample.tilt < kStands) stood = sample.time;
  return stood;
}

}  // namespace

std::optional<FloorPulse> largest_pulse(const FloorMotion& floor, const Vector2& direction,
                                        double from, double to) {
  if (floor.at_rest() || !(to > from)) return {};
  std::vector<double> times{std::max(from, 0.0)};
  const double step = floor.time_step();
  for (auto i = static_cast<long>(std::floor(times[0] / step)) + 1; i < to / step; ++i)
    times.push_back(static_cast<double>(i) * step);
  times.push_back(to);
  const auto velocity = [&](double t) { return direction.dot(floor.velocity_at(t).head<2>()); };
  FloorPulse pulse;
  double lowest = velocity(times[0]), since = times[0];
  for (const double t : times) {
    const double v = velocity(t);
    if (v - lowest > pulse.velocity_change) {
      pulse.start = since;
      pulse.end = t;
      pulse.velocity_change = v - lowest;
    }
    if (v < lowest + kNoise) since = t;
    lowest = std::min(lowest, v);
  }
  if (!(pulse.velocity_change > kNoPulse)) return {};
  for (const double t : times) {
    if (t < pulse.start || t > pulse.end) continue;
    const double acceleration = direction.dot(floor.acceleration_at(t).head<2>());
    if (acceleration <= pulse.peak_acceleration) continue;
    pulse.peak_acceleration = acceleration;
    pulse.time_of_peak = t;
  }
  return pulse;
}

std::vector<Fall> falls(const study::RunFacts& facts, const Response& response) {
  std::vector<Fall> result;
  if (is_failure(response.outcome)) return result;
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const Demands& d = response.items[i].demands;
    if (d.time_of_overturning < 0) continue;
    Fall fall{i, d.time_of_overturning, d.direction_of_overturning, {}, {}};
    for (std::size_t w = 0; w < d.wheels.size(); ++w)
      if (d.wheels[w].liftoff_before_overturning >= 0)
        fall.liftoffs.push_back({facts.scene.items.at(i).model.casters.at(w).name,
                                 d.wheels[w].liftoff_before_overturning});
    std::stable_sort(fall.liftoffs.begin(), fall.liftoffs.end(),
                     [](const auto& a, const auto& b) { return a.time < b.time; });
    if (std::isfinite(fall.direction)) {
      const double first = fall.liftoffs.empty() ? began_to_tip(response.items[i], fall.time)
                                                 : fall.liftoffs.front().time;
      fall.pulse =
          largest_pulse(facts.floor, -Vector2(std::cos(fall.direction), std::sin(fall.direction)),
                        first - Fall::kLookBack, fall.time);
    }
    result.push_back(fall);
  }
  return result;
}

}  // namespace gurney::report
