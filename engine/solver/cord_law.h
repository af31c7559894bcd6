#pragma once

#include <algorithm>

#include "engine/scene/room.h"

namespace gurney {

/// The law of a tether that is longer than its slack length by the stretch s at the end of a stage:
///
///     T = k s + min(max(c s', -k s), k s)  for s > 0, else 0.
struct CordForce {
  double elastic = 0, damping = 0;
  double slope = 0;  ///< dT/ds' >= 0, with s = s_0 + tau s'

  double sum() const { return elastic + damping; }
};

inline CordForce cord_force(const Tether& tether, double stretch, double rate, double tau) {
  CordForce force;
  if (!(stretch > 0)) return force;
  force.elastic = tether.stiffness * stretch;
  force.damping = std::clamp(tether.damping * rate, -force.elastic, force.elastic);
  const double elastic_slope = tether.stiffness * tau;
  if (force.damping >= force.elastic) {
    force.slope = 2 * elastic_slope;
  } else if (force.damping > -force.elastic) {
    force.slope = elastic_slope + tether.damping;
  }
  return force;
}

/// Direction in which a slack cord pulls, horizontally, and of what share of its slack pull: one that hangs
/// straight down pulls nowhere, and fully from a horizontal distance of 0.1 m on.
inline Vector3 slack_direction(Vector3 towards_anchor) {
  constexpr double kFullPull = 0.1;  // [m]
  towards_anchor.z() = 0;
  return towards_anchor / std::max(towards_anchor.norm(), kFullPull);
}

}  // namespace gurney
