#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/response/response.h"
#include "studies/results/run_facts.h"

namespace gurney::explanation {

/// Part of a floor's motion during which its velocity along a direction rises.
struct HalfCycle {
  Vector2 direction = Vector2::Zero();  ///< horizontal, a unit vector
  double start = 0, end = 0;            ///< [s]
  double velocity_change = 0;           ///< > 0 [m/s]
  double peak_velocity = 0;             ///< largest |velocity| along it, from start to end [m/s]
  double peak_acceleration = 0;         ///< largest along it, from start to end [m/s2]
  double time_of_peak = 0;              ///< of that [s]
};

/// How far before the motion of an item a half cycle that drives it may end [s].
inline constexpr double kLookBack = 1;

/// The half cycle of a floor's motion that drives an item which moves from `from` to `to`: of the
/// rises of its velocity along `direction` that end between these times, or go on at `to`, the
/// largest; without one, of those that end up to kLookBack before. A rise goes from a turning point
/// of the velocity to the next one; reversals below 20 % of the range of the velocity, from 2 s
/// before the first of these ends to `to`, are none. What comes before and after the acceleration
/// has 1 % of its peak is cut off. None where the velocity never changes by 1 mm/s.
std::optional<HalfCycle> driving_half_cycle(const FloorMotion& floor, const Vector2& direction,
                                            double from, double to);

/// How an item overturned.
struct Overturning {
  struct Liftoff {
    std::string wheel;
    double time = 0;  ///< [s]
  };

  std::size_t item = 0;
  bool topples = false;           ///< it stood on another item
  double time = 0;                ///< of overturning [s]
  double direction = 0;           ///< from the floor's x axis, -pi to pi [rad]
  std::vector<Liftoff> liftoffs;  ///< of the wheels in the air at `time`, by time
  /// The first of these. Without one, the last sample of the histories that the settings ask for,
  /// whatever their spacing is, with a tilt below 1 degree; else `time` [s].
  double start = 0;
  std::optional<HalfCycle> half_cycle;  ///< that drove it from `start` to `time`
};

/// In order of the items. Nothing of runs that diverged.
std::vector<Overturning> overturnings_of(const study::RunFacts& facts, const Response& response);

}  // namespace gurney::explanation
