#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/units.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/scenes.h"

// The thresholds of such a cart are in studies/verification/cases/friction_limits.cpp.
namespace gurney {
namespace {

using namespace scenes;

constexpr double kG = kStandardGravity;

// The unequal thresholds make such a cart creep one way under symmetric shaking: strong enough for
// one direction, too weak for the other.
TEST(HalfLockedCart, RatchetsTowardsTheFreeAxle) {
  constexpr double kFriction = 0.5, kWheelbase = 0.6;
  ItemOptions options;
  stiffen(options.caster.tread);
  options.caster.swivels = false;
  options.caster.trail = 0;
  options.caster.tread.rolling_friction_length = 0;
  options.caster.tread.static_friction = options.caster.tread.kinetic_friction = kFriction;
  options.half_wheelbase = kWheelbase / 2;
  options.chassis_center = {0, 0, 0.45};
  Scene scene = scene_of(trolley(options));
  for (int front : {0, 1})
    scene.items[0].model.casters[front].brake_torque = std::numeric_limits<double>::infinity();
  // The middle of the thresholds mu / 2 / (1 +- mu h / w).
  const double h = whole_item(scene.items[0].model).center_of_mass.z();
  const double level = kFriction / 2 / (1 - std::pow(kFriction * h / kWheelbase, 2));
  const FloorMotion floor = floor_motion(0.004, 5, Vector3::UnitX(), [=](double t) {
    return level * kG * std::sin(2 * std::numbers::pi * t) * std::min(1.0, t);
  });
  const auto response = simulate(scene, floor, run_for(5, 0.002, 0.1));
  EXPECT_LT(response.items[0].demands.residual_displacement_x, -0.1);
  double last = 0;
  for (const Sample& s : response.items[0].history) {
    EXPECT_LT(s.displacement.x(), last + 1e-4);  // the sway of the treads
    last = s.displacement.x();
  }
}

}  // namespace
}  // namespace gurney
