#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/scenes.h"

// Rolling resistance holds like dry friction: at rest the trolley carries up to f_r = (Cr / R) N
// without creep; beyond it, it rolls. On a slope tan(a) = s (x uphill), with J = sum I_w / R^2:
//
//     rests while s < Cr / R,   else a = M g cos(a) (s - Cr / R) / (M + J) downhill
namespace gurney {
namespace {

using namespace scenes;

constexpr double kG = kStandardGravity;
constexpr double kRolled = 1e-3;  // [m]; whatever holds moves less by orders

/// @param downhill  casters trail as the trolley rolls down (heading pi)
Scene on_slope(double slope, double resistance, bool downhill) {
  ItemOptions options;
  options.caster.tread.rolling_resistance = resistance * options.caster.wheel_radius;
  if (downhill) options.headings.assign(4, std::numbers::pi);
  Scene scene;
  scene.items[0].model = trolley(options);
  scene.slope = slope;
  return scene;
}

class Slope : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Slopes, Slope, testing::Values(0.005, 0.01, 0.03));

// A run starts from equilibrium, so nothing moves at all. The residual of the solve, 1e-9 M g dt
// each step, is not enough to creep: the treads are springs.
TEST_P(Slope, HoldsFor60sAt0p9OfTheThreshold) {
  const double slope = GetParam();
  for (const bool downhill : {false, true}) {
    const auto response =
        simulate(on_slope(slope, slope / 0.9, downhill), {}, run_for(60, 0.004, 1));
    EXPECT_LT(response.items[0].demands.peak_displacement, 1e-9);
    EXPECT_EQ(response.items[0].energy.rolling_loss, 0);
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(response.items[0].history.back().wheels[i].mode, WheelMode::kSticks);
  }
}

// Casters at other headings: the start is no equilibrium, since a loaded caster first turns by the
// wind-up of its scrub (2 mm of lever on 1e5 N/m: some tenths of a radian). The trolley rolls some
// millimetres, then holds: no creep from 30 s to 60 s.
TEST_P(Slope, HoldsWithCastersAtAnyHeading) {
  const double slope = GetParam();
  Scene scene = on_slope(slope, slope / 0.9, false);
  const double headings[] = {0.3, 1.6, 2.8, 5.2};
  for (int i = 0; i < 4; ++i) {
    scene.items[0].model.casters[i].heading = headings[i];
    scene.items[0].model.casters[i].swivel.coulomb = 0.03;
  }
  const auto response = simulate(scene, {}, run_for(60, 0.004, 30));
  ASSERT_EQ(response.items[0].history.size(), 3u);
  const Vector3 crept =
      response.items[0].history[2].displacement - response.items[0].history[1].displacement;
  EXPECT_LT(crept.norm(), 1e-8);
  EXPECT_LT(response.items[0].demands.peak_displacement, 0.03);
}

TEST_P(Slope, RollsAt1p1OfTheThreshold) {
  const double slope = GetParam();
  const auto response = simulate(on_slope(slope, slope / 1.1, true), {}, run_for(10, 0.004));
  EXPECT_GT(response.items[0].demands.residual_displacement, kRolled);
  EXPECT_LT(response.items[0].demands.residual_displacement_x, 0);
}

// From rest x = a t^2 / 2. Stiff treads: the wind-up (pulling_test.cpp) leaves less than 4e-5 of
// the velocity at 2 s for slopes that are twice the threshold or more.
TEST_P(Slope, AcceleratesAsTheClosedForm) {
  const double slope = GetParam(), angle = std::atan(slope);
  for (const double share : {0.0, 0.3, 0.5}) {
    SCOPED_TRACE(share);
    Scene scene = on_slope(slope, share * slope, true);
    for (Caster& caster : scene.items[0].model.casters) stiffen(caster.tread);
    const double mass = total_mass(scene.items[0].model);
    const double a = mass * kG * std::cos(angle) * slope * (1 - share) /
                     (mass + wheel_inertia_mass(scene.items[0].model));
    Excitation excitation;
    excitation.fixture = hold_rotations(false, true, false);
    const auto response = simulate(scene, excitation, run_for(4, 0.004, 2));
    for (const Sample& s : response.items[0].history) {
      EXPECT_NEAR(s.displacement.x(), -a * s.time * s.time / 2, 1e-4 * a * 8);
      EXPECT_NEAR(s.velocity.x(), -a * s.time, 1e-4 * a * 4);
    }
  }
}

// A harmonic floor motion that grows over 5 s, for 60 s. Below the threshold (Cr / R) g the trolley
// only sways on its treads, x = A / w_t^2 (w_t^2 = k / M, k = n k_t 10 / 11, see pulling_test.cpp);
// the envelope keeps the treads from ringing.
Response shaken(double amplitude, double resistance, double frequency, bool soft) {
  ItemOptions options;
  options.caster.tread.rolling_resistance = resistance * options.caster.wheel_radius;
  if (!soft) stiffen(options.caster.tread);
  Scene scene;
  scene.items[0].model = trolley(options);
  Excitation excitation;
  excitation.floor = floor_motion(0.004, 60, Vector3::UnitX(), [=](double t) {
    return amplitude * std::min({1.0, t / 5, (60 - t) / 5}) *
           std::sin(2 * std::numbers::pi * frequency * t);
  });
  return simulate(scene, excitation, run_for(65, 0.004, 0.05));
}

TEST(FloorMotion, Of0p005gBelowTheThresholdMovesNothingIn60s) {
  constexpr double kAmplitude = 0.005 * kG;
  for (const double frequency : {0.5, 1.0}) {
    SCOPED_TRACE(frequency);
    const auto response = shaken(kAmplitude, 0.005 / 0.9, frequency, true);
    // 20 % more than the static sway for the inertia of the sway itself and the pitch.
    const double sway = kAmplitude * 96.5 / (4 * 1e5 * 10.0 / 11);
    EXPECT_LT(response.items[0].demands.peak_displacement, 1.2 * sway);
    EXPECT_GT(response.items[0].demands.peak_displacement, 0.9 * sway);
    EXPECT_NEAR(response.items[0].energy.rolling_loss, 0, 1e-15);      // rounding
    EXPECT_LT(response.items[0].demands.residual_displacement, 1e-8);  // swung out, no creep
  }
}

TEST(FloorMotion, Of0p005gAboveTheThresholdMoves) {
  for (const double frequency : {0.5, 1.0}) {
    SCOPED_TRACE(frequency);
    const auto still = shaken(0.005 * kG, 0.005 / 0.9, frequency, false);
    const auto moved = shaken(0.005 * kG, 0.005 / 1.1, frequency, false);
    EXPECT_GT(moved.items[0].demands.peak_displacement,
              1000 * still.items[0].demands.peak_displacement);
    EXPECT_GT(moved.items[0].energy.rolling_loss, 0);
  }
}

}  // namespace
}  // namespace gurney
