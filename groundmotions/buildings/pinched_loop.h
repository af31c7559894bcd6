#pragma once

#include <array>

namespace gurney::groundmotions {

/// Where a reloading path bends: at `drift` of the way from where the force was zero to the line on which the
/// peak unloads, with `force` of the force at the peak. 1, 1: straight to the peak (Clough & Johnston 1966).
struct Pinching {
  double drift = 1;  ///< X in [0, 1]
  double force = 1;  ///< Y in (0, 1]
};

/// A bilinear spring along one line whose loops are pinched, as the material Hysteretic of OpenSees without
/// damage (docs/theory/buildings.md). Drift and force are over those at yield, so that it unloads with slope 1.
struct PinchedLoop {
  double drift = 0, force = 0;
  double origin = 0;                    ///< drift where the force was last zero
  std::array<double, 2> peak = {1, 1};  ///< farthest drifts downwards and upwards, >= 1
};

struct PinchedMove {
  PinchedLoop end;
  double mean = 0;  ///< of the force over the way
};

/// Where a way `by` leads, exactly.
/// @param hardening  slope of the backbone beyond yield, in [0, 1)
PinchedMove move(const PinchedLoop& start, double by, double hardening, const Pinching& pinching);

}  // namespace gurney::groundmotions
