#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/scenes.h"

// A wheel set down at v0 without spin skids until it rolls (any textbook on rigid-body motion, e.g.
// Landau & Lifshitz; a bowling ball). With the carried mass m, k = I / (m R^2):
//
//     v_end = v0 / (1 + k),   t = v0 k / (mu g (1 + k)),   distance v0 t - mu g t^2 / 2
//
// k = 1/2 (a cylinder): v_end = 2/3 v0, t = v0 / (3 mu g), distance 5 v0^2 / (18 mu g).
namespace gurney {
namespace {

using namespace scenes;

constexpr double kG = kStandardGravity;
constexpr double kMass = 10;

struct Skid {
  double v0, mu, k;
};

class SkidToRoll : public testing::TestWithParam<Skid> {
 protected:
  /// A wheel on a rigid fork below a small chassis that the fixture keeps upright. The mass that
  /// the wheel carries counts as its own: only its spin inertia is in the closed form besides.
  Response run(double time_step, double duration, double history_step) const {
    const auto [v0, mu, k] = GetParam();
    Caster caster = rubber_caster();
    stiffen(caster.tread);
    caster.tread.rolling_resistance = 0;
    caster.tread.static_friction = caster.tread.kinetic_friction = mu;
    caster.swivels = false;
    caster.trail = 0;
    caster.wheel_axial_inertia = k * kMass * caster.wheel_radius * caster.wheel_radius;
    caster.wheel_transverse_inertia = caster.wheel_axial_inertia;
    Scene scene;
    scene.items[0].model = single_caster(kMass, caster);
    scene.items[0].initial.velocity.x() = v0;
    scene.items[0].initial.wheels_roll = false;
    Excitation excitation;
    excitation.fixture = hold_rotations();
    return simulate(scene, excitation, run_for(duration, time_step, history_step));
  }
};

// Until it rolls the wheel is a block under constant force; the treads wind up over
// (mu N)^2 / (2 k_t) of energy, 1e-6 J at most. The change to rolling happens once, inside a step:
// it costs O((mu g dt)^2) of displacement and nothing of the speed after (angular momentum about
// the contact line is kept by every step).
TEST_P(SkidToRoll, ReachesTheSpeedTimeAndDistance) {
  const auto [v0, mu, k] = GetParam();
  const double roll_time = v0 * k / (mu * kG * (1 + k)), v_end = v0 / (1 + k);
  const double distance = v0 * roll_time - mu * kG * roll_time * roll_time / 2;
  constexpr double kStep = 0.0005;
  const double duration = std::ceil(2 * roll_time / kStep) * kStep;
  const auto response = run(kStep, duration, kStep);

  // The tread springs back when the skid ends and rings against mass and wheel for some steps, with
  // a speed mu N / k_t sqrt(k_t / m_r) m_r / m, m_r the reduced mass m k / (1 + k).
  const double ring = mu * kG * std::sqrt(kMass * k / (1 + k) / 1e9);

  double first_roll = 0;
  const double slack = mu * kG * kStep * kStep + 1e-6;
  for (const Sample& s : response.items[0].history) {
    SCOPED_TRACE(s.time);
    const double t = std::min(s.time, roll_time);
    const double x = v0 * t - mu * kG * t * t / 2 + v_end * (s.time - t);
    ASSERT_NEAR(s.displacement.x(), x, slack);
    if (std::abs(s.time - roll_time) > kStep) {
      ASSERT_NEAR(s.velocity.x(), v0 - mu * kG * t, 2e-6 * v0 + (s.time > roll_time ? ring : 0));
    }
    const WheelSample& wheel = s.wheels[0];
    if (s.time == 0) continue;
    if (wheel.mode != WheelMode::kSkids && first_roll == 0) first_roll = s.time;
    ASSERT_GE(0.05 * wheel.wheel_rate, -1e-9);
  }
  EXPECT_NEAR(first_roll, roll_time, 2 * kStep);
  const Sample& end = response.items[0].history.back();
  EXPECT_NEAR(end.velocity.x(), v_end, 2e-6 * v0);
  EXPECT_NEAR(0.05 * end.wheels[0].wheel_rate, v_end, 2e-6 * v0);
  // Skidding ends at the distance; the patch has slipped by the mean slip v0 / 2 for that time.
  EXPECT_NEAR(response.items[0].demands.wheels[0].skid_distance, v0 * roll_time / 2,
              2e-3 * distance);
  // The loss is that of kinetic energy: m v0^2 k / (2 (1 + k)).
  const double loss = kMass * v0 * v0 * k / (2 * (1 + k));
  EXPECT_NEAR(response.items[0].energy.sliding_loss, loss, 1e-3 * loss);
}

INSTANTIATE_TEST_SUITE_P(Wheels, SkidToRoll,
                         testing::Values(Skid{1, 0.3, 0.5}, Skid{2, 0.3, 0.5}, Skid{1, 0.6, 1},
                                         Skid{0.5, 0.15, 0.2}, Skid{3, 0.8, 0.05}));

// A wheel that starts rolling goes on at its speed.
TEST_P(SkidToRoll, DoesNotHappenToAWheelThatRolls) {
  const auto [v0, mu, k] = GetParam();
  Caster caster = rubber_caster();
  caster.tread.rolling_resistance = 0;
  caster.swivels = false;
  Scene scene;
  scene.items[0].model = single_caster(kMass, caster);
  scene.items[0].initial.velocity.x() = v0;
  Excitation excitation;
  excitation.fixture = hold_rotations();
  const auto response = simulate(scene, excitation, run_for(1, 0.004, 1));
  EXPECT_NEAR(response.items[0].history.back().velocity.x(), v0, 1e-10);
  EXPECT_EQ(response.items[0].energy.sliding_loss, 0);
}

}  // namespace
}  // namespace gurney
