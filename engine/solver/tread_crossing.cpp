#include "engine/solver/tread_crossing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/solver/quadrature.h"

namespace gurney {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// First root of c + r t + a t^2 / 2 within (from, to) where the rate is at least `least`.
double first_root(double c, double r, double a, double from, double to, double least) {
  const double root = r * r - 2 * a * c;
  if (!(root > least * least)) return kNever;  // the rate at both roots is +-sqrt(root)
  const double q = -(r + std::copysign(std::sqrt(root), r));
  double earliest = kNever;
  for (const double t : {2 * c / q, q / a})
    if (t > from && t < to) earliest = std::min(earliest, t);
  return earliest;
}

}  // namespace

void TreadCrossings::observe(std::size_t item, std::size_t casters, double duration,
                             const ItemStage::Output& first, const ItemStage::Output& end,
                             double floor_up) {
  Item& now = items_[item];
  now.wheels = casters;
  now.floor_up = floor_up;
  for (std::size_t i = 0; i < casters; ++i) {
    const double rate = end.treads[i].compression_rate;
    now.wheel[i] = {end.treads[i].compression, rate,
                    (rate - first.treads[i].compression_rate) / ((1 - kSdirkGamma) * duration)};
  }
}

bool TreadCrossings::near(const Island& island, double duration) const {
  for (std::size_t i : island.items) {
    const Item& item = items_[i];
    // Twice the acceleration, for that of the floor may change.
    for (std::size_t k = 0; k < item.wheels; ++k) {
      const Wheel& wheel = item.wheel[k];
      if (std::abs(wheel.compression) <
          duration * (std::abs(wheel.rate) + duration * std::abs(wheel.acceleration)))
        return true;
    }
  }
  return false;
}

double TreadCrossings::first(const Island& island, double floor_up, double duration) const {
  double earliest = kNever;
  for (std::size_t i : island.items) {
    const Item& item = items_[i];
    for (std::size_t k = 0; k < item.wheels; ++k) {
      const Wheel& wheel = item.wheel[k];
      const double acceleration = wheel.acceleration + floor_up - item.floor_up;
      earliest = std::min(
          earliest, first_root(wheel.compression, wheel.rate, acceleration, kNearEnd * duration,
                               (1 - kNearEnd) * duration, kLeastSpeed));
    }
  }
  return earliest;
}

}  // namespace gurney
