#include "groundmotions/buildings/isolation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"

namespace gurney::groundmotions {

double Isolation::strength(double speed) const {
  if (fast_strength == slow_strength) return fast_strength;
  return fast_strength - (fast_strength - slow_strength) * std::exp(-strength_rate * speed);
}

Isolation linear_isolation(double period, double damping) {
  assert(period > 0 && damping >= 0);
  const double omega = 2 * std::numbers::pi / period;
  Isolation isolation;
  isolation.name = "linear";
  isolation.stiffness = omega * omega;
  isolation.viscosity = 2 * damping * omega;
  return isolation;
}

Isolation lead_rubber(double period, double strength_ratio, double yield_displacement,
                      double damping) {
  assert(strength_ratio > 0 && yield_displacement > 0);
  Isolation isolation = linear_isolation(period, damping);
  isolation.name = "lead rubber";
  isolation.slow_strength = isolation.fast_strength = strength_ratio * kStandardGravity;
  isolation.yield_displacement = yield_displacement;
  return isolation;
}

Isolation friction_pendulum(double radius, double slow, double fast, double rate,
                            double yield_displacement) {
  assert(radius > 0 && slow >= 0 && fast >= slow && rate >= 0 && yield_displacement > 0);
  Isolation isolation;
  isolation.name = "friction pendulum";
  isolation.stiffness = kStandardGravity / radius;
  isolation.slow_strength = slow * kStandardGravity;
  isolation.fast_strength = fast * kStandardGravity;
  isolation.strength_rate = rate;
  isolation.yield_displacement = yield_displacement;
  isolation.follows_vertical = true;
  return isolation;
}

Sliding slide(const Vector2& z, const Vector2& increment) {
  const Vector2 trial = z + increment;
  if (trial.squaredNorm() <= 1) return {trial, (z + trial) / 2};

  const double length = increment.norm();
  const Vector2 along = increment / length;
  const double inside = std::max(0.0, 1 - z.squaredNorm());
  const double start = z.dot(along);
  const double cosine = std::sqrt(start * start + inside);  // of psi where z meets the edge
  const double elastic = cosine - start;
  const Vector2 edge = z + elastic * along;
  const Vector2 across = edge - cosine * along;
  const double sine = across.norm();
  const Vector2 aside = sine > 0 ? Vector2(across / sine) : Vector2(Vector2::Zero());

  const double plastic = std::max(0.0, length - elastic);
  const double before = sine / (1 + cosine);  // tan(psi / 2)
  const double after = before * std::exp(-plastic);
  const double scale = 1 + after * after;
  Sliding result;
  result.end = (1 - after * after) / scale * along + 2 * after / scale * aside;
  result.mean =
      (elastic * (z + edge) / 2 + (plastic + std::log(scale / (1 + before * before))) * along +
       2 * (std::atan(before) - std::atan(after)) * aside) /
      length;
  return result;
}

}  // namespace gurney::groundmotions
