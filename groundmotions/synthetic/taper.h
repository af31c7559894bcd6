#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gurney::groundmotions {

/// 1 in the middle, 0 at 0 s and at `duration` and outside, sin^2 over `taper` at each end.
inline double trapezoid_taper(double time, double duration, double taper) {
  const double to_end = std::min(time, duration - time);
  if (to_end <= 0) return 0;
  if (to_end >= taper) return 1;
  return std::pow(std::sin(std::numbers::pi / 2 * to_end / taper), 2);
}

}  // namespace gurney::groundmotions
