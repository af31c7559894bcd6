#pragma once

#include <algorithm>
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

/// A body on wheels that still stick and springs that let it pitch (k_p) begins by pitching about
/// their axles, `h` below its centre of mass: (I_p + M h^2) theta'' + k_p theta = F h, until the
/// wheels hold F - M h theta'' = f. At the most, without damping, that adds
///
///     h theta' - (F - f) t1 / M   [m/s]
///
/// and nothing where the push on the wheels is f at once.
inline double pitching_speed(double F, double f, double M, double h, double I_p, double k_p) {
  const double inertia = I_p + M * h * h;
  const double share = (F * h - inertia * (F - f) / (M * h)) / (F * h);  // theta(t1) k_p / (F h)
  if (share <= 0) return 0;
  const double w = std::sqrt(k_p / inertia), t1 = std::acos(1 - std::min(share, 2.0)) / w;
  return h * F * h / k_p * w * std::sin(w * t1) - (F - f) * t1 / M;
}

}  // namespace gurney
