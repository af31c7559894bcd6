#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/response/response.h"
#include "studies/study/results/run_facts.h"

namespace gurney::report {

/// A rise of the floor's velocity in one direction.
struct FloorPulse {
  double start = 0, end = 0;     ///< [s]
  double velocity_change = 0;    ///< in the direction, > 0 [m/s]
  double peak_acceleration = 0;  ///< largest in the direction, at samples from start to end [m/s2]
  double time_of_peak = 0;       ///< of that [s]
};

/// The largest rise of the velocity of a floor along `direction` (horizontal, a unit vector) from
/// any time to any later one between `from` and `to`. None where it never rises by 1 mm/s.
std::optional<FloorPulse> largest_pulse(const FloorMotion& floor, const Vector2& direction,
                                        double from, double to);

/// How an item overturned.
struct Fall {
  struct Liftoff {
    std::string wheel;
    double time = 0;  ///< [s]
  };
  static constexpr double kLookBack = 1;  ///< [s]

  std::size_t item = 0;
  double time = 0;                ///< of overturning [s]
  double direction = 0;           ///< from the floor's x axis, -pi to pi [rad]
  std::vector<Liftoff> liftoffs;  ///< of the wheels in the air at `time`, by time
  /// The largest pulse of the floor against the direction of the fall, which is the way that tips
  /// the item over, from kLookBack before the first of these liftoffs to `time`. Without
  /// liftoffs: before the last sample of the histories whose tilt is below 1 degree.
  std::optional<FloorPulse> pulse;
};

/// In order of the items. Nothing of runs that diverged.
std::vector<Fall> falls(const study::RunFacts& facts, const Response& response);

}  // namespace gurney::report
