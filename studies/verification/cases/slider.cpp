#include "studies/verification/cases/slider.h"

#include <cmath>

#include "engine/base/units.h"
#include "studies/verification/scenes/scenes.h"

namespace gurney::verification::sliding {

using namespace scenes;

Slider make_slider(bool rolls, double mu, double tangential_stiffness) {
  ItemOptions options;
  Caster& caster = options.caster;
  stiffen(caster.tread);
  caster.tread.tangential_stiffness = tangential_stiffness;
  if (rolls) {
    caster.tread.rolling_friction_length = mu * caster.wheel_radius;
    caster.swivels = false;
  } else {
    caster.tread.static_friction = caster.tread.kinetic_friction = mu;
  }
  Slider slider{rolls ? trolley(options) : locked_block(options), 1, 0,
                4 * tangential_stiffness * 10 / 11};
  const double mass = total_mass(slider.item);
  if (rolls) slider.scale = mass / (mass + wheel_inertia_mass(slider.item));
  slider.wind_up = mu * kStandardGravity * std::sqrt(mass / slider.stiffness);
  return slider;
}

Response shake(const Slider& slider, const FloorMotion& floor, const SimulationSettings& settings,
               double speed, const Runner& runner, Findings& findings) {
  Scene scene = scene_of(slider.item);
  scene.items[0].initial.velocity.x() = speed;
  scene.items[0].initial.wheels_roll = slider.item.casters[0].brake_torque == 0;
  scene.items[0].fixture = hold_rotations();
  return runner(findings, scene, floor, settings);
}

}  // namespace gurney::verification::sliding
