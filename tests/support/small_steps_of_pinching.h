#pragma once

#include <algorithm>
#include <cmath>

namespace gurney {

/// The pinching rule of docs/theory/buildings.md as increments of a load history: each small step adds its own
/// elastic force, which the path of reloading limits.
struct SmallStepsOfPinching {
  SmallStepsOfPinching(double hardening, double drift_ratio, double force_ratio)
      : alpha(hardening), x(drift_ratio), y(force_ratio) {}

  void go(double by) {
    const bool up = by > 0;
    const double s = up ? 1 : -1;
    double& zero = up ? zero_up : zero_down;
    // On a reversal, where the force will be zero.
    if (s != last && s * force <= 0) zero = drift - force;
    last = s;
    drift += by;
    force += by;
    double& peak = up ? highest : lowest;
    peak = s * std::max(s * peak, s * drift);
    const bool unloads = s * (drift - zero) < 0;
    force = s * std::min(s * force, unloads ? 0 : s * path(s, peak, zero));
  }

  double drift = 0, force = 0;

 private:
  double path(double s, double peak, double zero) const {
    const double at_peak = s + alpha * (peak - s);
    const double bend = zero + x * (peak - (1 - y) * at_peak - zero);
    if (s * drift < s * bend) return y * at_peak * (drift - zero) / (bend - zero);
    if (peak == bend) return at_peak;
    return y * at_peak + (1 - y) * at_peak * (drift - bend) / (peak - bend);
  }

  double alpha, x, y;
  double highest = 1, lowest = -1, zero_up = 0, zero_down = 0, last = 0;
};

}  // namespace gurney
