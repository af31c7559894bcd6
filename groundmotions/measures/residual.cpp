#include "groundmotions/measures/residual.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "groundmotions/measures/peaks.h"

namespace gurney::groundmotions {

namespace {

constexpr double kMeanAcceleration = 1e-4 * kStandardGravity;  // [m/s2]
constexpr double kInvisibleVelocity = 0.01;                    // [m/s]
constexpr double kVisibleDisplacement = 0.05;                  // [m]
constexpr double kShareOfPeak = 0.5;

/// Largest horizontal displacement of the floor at a sample.
double peak_displacement(const FloorMotion& floor) {
  const auto& a = floor.acceleration();
  return peaks(floor.time_step(), a.row(0), a.row(1)).displacement;
}

}  // namespace

Residual residual(const FloorMotion& floor) {
  Residual result;
  if (floor.at_rest()) return result;
  result.velocity = floor.residual_velocity();
  result.displacement = floor.residual_displacement();

  const double duration = floor.duration();
  const double speed = result.velocity.head<2>().norm();
  const double allowed =
      std::clamp(kMeanAcceleration * duration, kInvisibleVelocity, kVisibleVelocity);
  if (speed > allowed)
    result.warnings.push_back(fmt::format(
        "the floor still moves at {:.3g} m/s when the record ends ({:.3g} m/s are plausible after "
        "{:.3g} s): the same as a constant baseline error of {:.2g} g, which alone carries a free "
        "roller {:.2g} m; correct the baseline of the record",
        speed, allowed, duration, speed / duration / kStandardGravity, speed * duration / 2));

  const double away = result.displacement.head<2>().norm();
  const double peak = peak_displacement(floor);
  if (away > kVisibleDisplacement && away > kShareOfPeak * peak)
    result.warnings.push_back(fmt::format(
        "the floor ends {:.3g} m from where it began (its largest displacement is {:.3g} m): "
        "either "
        "permanent ground displacement near a fault or a baseline error; check the record",
        away, peak));
  return result;
}

}  // namespace gurney::groundmotions
