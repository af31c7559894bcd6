#pragma once

#include <cmath>

namespace gurney {

/// Speed that winding up adds to a body that a force F starts to move against a resistance f < F.
///
/// A stuck contact resists as a spring k until f is reached at x1 = f / k. Until then the body of
/// mass M is an oscillator, w^2 = k / M: t1 = acos(1 - f / F) / w, v1^2 = f (2 F - f) / (k M).
/// Rigid, it would have (F - f) t1 / M by then; the difference stays, and is
///
///     (sqrt(f (2 F - f)) - (F - f) acos(1 - f / F)) / sqrt(k M)   [m/s]
inline double wind_up_speed(double F, double f, double k, double M) {
  return (std::sqrt(f * (2 * F - f)) - (F - f) * std::acos(1 - f / F)) / std::sqrt(k * M);
}

}  // namespace gurney
