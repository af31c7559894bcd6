#include <gtest/gtest.h>

#include <cmath>

#include "engine/run/simulate.h"
#include "studies/verification/scenes/scenes.h"

// A cart on four braked wheels that do not skid is pushed along them. It holds up to
// F = 4 T / R, from there on slides on against r F, and once it stands it holds F again. Wheels
// turn with it: it has the mass M + 4 I / R^2.
namespace gurney {
namespace {

using namespace scenes;

constexpr double kTorque = 10, kRatio = 0.6, kStep = 0.002;

EquipmentModel braked_cart() {
  ItemOptions options;
  stiffen(options.caster.tread);
  Caster& caster = options.caster;
  caster.tread.rolling_friction_length = 0;
  caster.tread.static_friction = caster.tread.kinetic_friction = 5;
  caster.axle = {};
  caster.swivels = false;
  caster.trail = 0;
  caster.brake_torque = kTorque;
  caster.brake_sliding_ratio = kRatio;
  return trolley(options);
}

TEST(Brake, HoldsMoreThanItSlidesWithAndHoldsAgain) {
  const EquipmentModel item = braked_cart();
  const Caster& caster = item.casters[0];
  const double radius = caster.wheel_radius, held = 4 * kTorque / radius;
  const double mass = whole_item(item).mass + 4 * caster.wheel_axial_inertia / (radius * radius);
  // Pushed with 1.02 of that, let go, and pushed with 0.98, all up and down over 0.5 s.
  constexpr double kPush = 1.02;
  Scene scene = scene_of(item);
  scene.items[0].fixture = hold_rotations();
  scene.items[0].loads = {
      PointForce{"push",
                 item.marked_points[0].position,
                 Vector3::UnitX(),
                 {0, 0.5, 1, 1.001, 3, 3.5, 4},
                 {0, kPush * held, kPush * held, 0, 0, 0.98 * held, 0.98 * held}}};
  const Response response = simulate(scene, {}, run_for(4, kStep, kStep));
  const auto at = [&](double time) {
    return response.items[0].history[static_cast<std::size_t>(std::lround(time / kStep))];
  };

  // It goes at t_1 with a_1 = (1 - r) F / M', which rises with the push until 0.5 s.
  const double begins = 0.5 / kPush, rises = 0.5 - begins;
  const double first = (1 - kRatio) * held / mass, second = (kPush - kRatio) * held / mass;
  const double speed = rises * (first + second) / 2 + 0.5 * second;
  const double path = rises * rises * (2 * first + second) / 6 +
                      0.5 * rises * (first + second) / 2 + 0.125 * second;
  // The start is late by a step at most, which slides on as it held; windings of brakes and treads
  // under F are below 1e-5 m.
  const double late = 2 * kStep * second;
  EXPECT_LT(at(begins - kStep).displacement.x(), 1e-5);
  EXPECT_NEAR(at(1).velocity.x(), speed, late);
  EXPECT_NEAR(at(1).displacement.x(), path, late * 0.5 + 1e-5);
  // Then r F alone: v^2 / (2 a) on, with what the push of 1 ms adds to it.
  const double slows = kRatio * held / mass;
  const double stands = at(3).displacement.x();
  EXPECT_NEAR(stands, path + speed * speed / (2 * slows),
              late * 0.5 + late * speed / slows + 0.0005 * kPush * held / mass * speed / slows);
  EXPECT_NEAR(at(4).displacement.x(), stands, 1e-5);
}

}  // namespace
}  // namespace gurney
