#pragma once

#include <cmath>

#include "studies/verification/check.h"
#include "studies/verification/scenes/scenes.h"

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
inline Slider make_slider(bool rolls, double mu, double tangential_stiffness = 1e11) {
  scenes::ItemOptions options;
  Caster& caster = options.caster;
  scenes::stiffen(caster.tread);
  caster.tread.tangential_stiffness = tangential_stiffness;
  if (rolls) {
    caster.tread.rolling_friction_length = mu * caster.wheel_radius;
    caster.swivels = false;
  } else {
    caster.tread.static_friction = caster.tread.kinetic_friction = mu;
  }
  Slider slider{rolls ? scenes::trolley(options) : scenes::locked_block(options), 1, 0,
                4 * tangential_stiffness * 10 / 11};
  const double mass = scenes::total_mass(slider.item);
  if (rolls) slider.scale = mass / (mass + scenes::wheel_inertia_mass(slider.item));
  slider.wind_up = mu * kG * std::sqrt(mass / slider.stiffness);
  return slider;
}

/// Starts along x at `speed`.
inline Response shake(const Slider& slider, const FloorMotion& floor,
                      const SimulationSettings& settings, double speed, Runner& runner) {
  Scene scene = scene_of(slider.item);
  scene.items[0].initial.velocity.x() = speed;
  scene.items[0].initial.wheels_roll = slider.item.casters[0].brake_torque == 0;
  scene.items[0].fixture = scenes::hold_rotations();
  return runner(scene, floor, settings);
}

}  // namespace gurney::verification::sliding
