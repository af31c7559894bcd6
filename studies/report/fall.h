#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/response/response.h"
#include "studies/report/half_cycle.h"
#include "studies/results/run_facts.h"

namespace gurney::report {

/// How an item overturned.
struct Fall {
  struct Liftoff {
    std::string wheel;
    double time = 0;  ///< [s]
  };

  std::size_t item = 0;
  double time = 0;                ///< of overturning [s]
  double direction = 0;           ///< from the floor's x axis, -pi to pi [rad]
  std::vector<Liftoff> liftoffs;  ///< of the wheels in the air at `time`, by time
  /// The first of these. Without one, the last sample of the histories that the settings ask for,
  /// whatever their spacing is, with a tilt below 1 degree; else `time` [s].
  double start = 0;
  std::optional<HalfCycle> half_cycle;  ///< that drove it from `start` to `time`
};

/// In order of the items. Nothing of runs that diverged.
std::vector<Fall> falls(const study::RunFacts& facts, const Response& response);

}  // namespace gurney::report
