#include "groundmotions/buildings/pinched_loop.h"

#include <algorithm>
#include <cmath>

namespace gurney::groundmotions {
namespace {

/// A way upwards, piece by piece.
struct Way {
  double drift, force;
  double end;  ///< drift
  double work = 0;

  void go(double to, double slope) {
    to = std::min(to, end);
    if (!(to > drift)) return;
    const double next = force + slope * (to - drift);
    work += (to - drift) * (force + next) / 2;
    drift = to;
    force = next;
  }

  /// Loads with slope 1 until it meets the line from (a, at_a) to (b, at_b), and then along that.
  void load(double a, double at_a, double b, double at_b) {
    if (!(b > a && b > drift)) return;
    const double slope = std::min((at_b - at_a) / (b - a), 1.0);
    if (force + (b - drift) > at_b) {
      const double below = std::max(0.0, at_a + slope * (drift - a) - force);
      if (slope < 1) go(std::min(drift + below / (1 - slope), b), 1);
      go(b, slope);
    } else {
      go(b, 1);
    }
  }
};

}  // namespace

PinchedMove move(const PinchedLoop& start, double by, double hardening, const Pinching& pinching) {
  if (start.drift + by == start.drift) return {start, start.force};
  PinchedMove result{start};
  PinchedLoop& end = result.end;
  const double sign = by > 0 ? 1 : -1;
  Way way{sign * start.drift, sign * start.force, sign * (start.drift + by)};
  if (way.force < 0) {
    const double zero = way.drift - way.force;
    way.go(zero, 1);
    if (zero <= way.end) {
      way.force = 0;
      end.origin = sign * way.drift;
    }
  }
  double& peak = end.peak[by > 0 ? 1 : 0];
  const double strength = 1 + hardening * (peak - 1);
  const double origin = sign * end.origin;
  const double pinched = pinching.force * strength;
  const double bend = origin + pinching.drift * (peak - (strength - pinched) - origin);
  way.load(origin, 0, bend, pinched);
  way.load(bend, pinched, peak, strength);
  way.load(peak, strength, way.end, strength + hardening * (way.end - peak));
  peak = std::max(peak, way.end);
  end.drift = start.drift + by;
  end.force = sign * way.force;
  result.mean = sign * way.work / std::abs(end.drift - start.drift);
  return result;
}

}  // namespace gurney::groundmotions
