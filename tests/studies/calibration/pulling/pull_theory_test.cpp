#include <gtest/gtest.h>

#include <cmath>

#include "studies/calibration/pulling/simulated_trial.h"
#include "studies/verification/scenes/scenes.h"
#include "tests/support/error_text.h"

namespace gurney::calibration {
namespace {

using namespace scenes;

// 100 kg, g = 10 m/s2, Cr / R = 0.02: f = 20 N; four discs of 0.25 kg: J = 4 x 0.125 = 0.5 kg.
Scene round_scene(std::vector<Load> loads = {}) {
  ItemOptions options;
  options.total_mass = 100;
  options.caster.tread.rolling_friction_length = 0.02 * options.caster.wheel_radius;
  Scene scene = scene_of(trolley(options));
  scene.gravity = 10;
  scene.items[0].loads = std::move(loads);
  return scene;
}

// F_w = 2 N, F_s = 3 N, m = 6 kg, p = 0.00125 / 0.05^2 = 0.5 kg:
// a_1 = (60 - 2 - 20 - 3) / (100 + 0.5 + 6 + 0.5) = 35 / 107, T = 58 - 6.5 a_1, a_2 = 23 / 100.5.
std::vector<Load> round_weight(double mass = 6, const Vector3& direction = Vector3::UnitX()) {
  DropWeight weight;
  weight.mass = mass;
  weight.direction = direction;
  weight.drop_height = 0.8;
  weight.pulley_inertia = 0.00125;
  weight.pulley_radius = 0.05;
  weight.potentiometer_tension = 2;
  Blocks blocks;
  blocks.release_time = 0.5;
  return {weight, blocks, StringPotentiometer{Vector3::Zero(), -2 * Vector3::UnitX(), 3}};
}

TEST(PullTheory, OfADropWeightIsNewtonsLawOfTheTrain) {
  const PullTheory theory = theory_of(round_scene(round_weight()));
  const double a1 = 35.0 / 107, a2 = 23 / 100.5, v = std::sqrt(2 * a1 * 0.8);
  EXPECT_NEAR(theory.resistance, 20, 1e-12);
  EXPECT_NEAR(theory.string_tension, 3, 1e-12);
  EXPECT_NEAR(theory.acceleration, a1, 1e-12);
  EXPECT_NEAR(theory.deceleration, a2, 1e-12);
  EXPECT_NEAR(theory.force, 58 - 6.5 * a1, 1e-12);
  EXPECT_NEAR(theory.held_force, 58, 1e-12);
  EXPECT_NEAR(theory.release, 0.5 + v / a1, 1e-12);
  EXPECT_NEAR(theory.release_displacement, 0.8, 1e-12) << "as far as the weight falls";
  EXPECT_NEAR(theory.rest_displacement, 0.8 + v * v / (2 * a2), 1e-12);
  EXPECT_NEAR(theory.velocity_at(theory.release), v, 1e-12);
  EXPECT_NEAR(theory.displacement_at(theory.stop + 1), theory.rest_displacement, 1e-12);
  EXPECT_EQ(theory.displacement_at(0.4), 0);
  EXPECT_EQ(theory.acceleration_at(theory.release + 0.1), -theory.deceleration);
  EXPECT_EQ(theory.force_at(0.4), theory.held_force);
  EXPECT_EQ(theory.force_at(theory.release + 0.1), 0);
}

TEST(PullTheory, OfAConstantForceKnowsNoWeight) {
  const PullTheory theory = theory_of(round_scene({constant_force(40.1, 3, Vector3::Zero())}));
  EXPECT_NEAR(theory.acceleration, 20.1 / 100.5, 1e-12);
  EXPECT_NEAR(theory.release_displacement, 0.5 * 0.2 * 9, 1e-12);
  EXPECT_NEAR(theory.stop, 3 + 0.6 / (20 / 100.5), 1e-12);
  EXPECT_EQ(theory.drop_mass, 0);
  EXPECT_EQ(theory.force_at(1), 40.1);
}

// F = 40 t N over 1 s, then 40 N for 2 s, on M + J = 100.5 kg against f = 20 N: with i = 1 / 100.5,
// v(1) = (20 - 20) i = 0, x(1) = (40 / 6 - 20 / 2) i; v(3) = 20 x 2 i, x(3) = x(1) + 20 x 2^2 / 2 i.
TEST(PullTheory, OfASampledForceIsItsDoubleIntegral) {
  const PointForce force{
      "measured", Vector3::Zero(), Vector3::UnitX(), {0.5, 1.5, 3.5}, {0, 40, 40}};
  const PullTheory theory = theory_of(round_scene({force}));
  const double i = 1 / 100.5, x1 = (40.0 / 6 - 10) * i, x3 = x1 + 40 * i, v3 = 40 * i;
  EXPECT_NEAR(theory.displacement_at(1), (40 * 0.125 / 6 - 20 * 0.125) * i, 1e-15);
  EXPECT_NEAR(theory.velocity_at(1.5), 0, 1e-15);
  EXPECT_NEAR(theory.displacement_at(1.5), x1, 1e-15);
  EXPECT_NEAR(theory.release_velocity, v3, 1e-15);
  EXPECT_NEAR(theory.release_displacement, x3, 1e-15);
  EXPECT_NEAR(theory.rest_displacement, x3 + v3 * v3 / 2 / (20 * i), 1e-15);
  EXPECT_NEAR(theory.force, (20.0 + 80) / 3, 1e-12) << "mean of the pull";
  EXPECT_NEAR(theory.force_at(1), 20, 1e-12);
  EXPECT_NEAR(theory.acceleration_at(1), 0, 1e-15) << "the force balances the resistance";
}

TEST(PullTheory, RefusesWhatItDoesNotDescribe) {
  const auto error = [&](const std::vector<Load>& loads) {
    return error_text([&] { theory_of(round_scene(loads)); });
  };
  EXPECT_EQ(
      error({}),
      "is no pulling test: one item on casters must be pulled along x by one drop weight that "
      "blocks hold, or by one force without a speed limit");
  EXPECT_EQ(error(round_weight(6, Vector3::UnitY())).substr(0, 18), "is no pulling test");
  EXPECT_EQ(error(round_weight(2)),
            "is no pulling test: the pull must move the item, which must come to rest after it");
}

}  // namespace
}  // namespace gurney::calibration
