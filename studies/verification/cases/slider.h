#pragma once

#include "engine/base/floor_motion.h"
#include "engine/scene/scene.h"
#include "studies/verification/runner.h"

/// A trolley on locked, rigid casters is a block on a Coulomb contact; one that rolls straight is a
/// block with mu = Cr / R whose relative accelerations are all scaled by M / (M + J), J = sum I_w /
/// R^2. Treads are stiffer still than elsewhere, and rotations are held.
namespace gurney::verification::sliding {

struct Slider {
  EquipmentModel item;
  double scale;      ///< of its motion against the block's
  double wind_up;    ///< the most that winding up adds at a reversal, mu g sqrt(M / k) [m/s]
  double stiffness;  ///< k = 4 k_t 10 / 11 [N/m]
};

/// @param rolls  a cart with Cr / R = mu, else a block
/// @param tangential_stiffness  k_t of each tread [N/m]
Slider make_slider(bool rolls, double mu, double tangential_stiffness = 1e11);

/// Starts along x at `speed`.
Response shake(const Slider& slider, const FloorMotion& floor, const SimulationSettings& settings,
               double speed, const Runner& runner, Findings& findings);

}  // namespace gurney::verification::sliding
