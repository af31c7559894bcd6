#include <gtest/gtest.h>

#include <numbers>

#include "engine/base/units.h"
#include "engine/record/energy_balance.h"
#include "engine/run/run.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/small_scenes.h"
#include "tests/support/error_text.h"

namespace gurney {
namespace {

using std::numbers::pi;

constexpr double kStep = 0.01;  // of the motion [s]
constexpr Eigen::Index kSamples = 601;

/// About y by theta_0 sin(w t), about x by half of it.
FloorRotation rocking(double angle, double frequency, bool with_acceleration) {
  FloorRotation rotation{Eigen::Matrix3Xd(3, kSamples), Eigen::Matrix3Xd(3, kSamples)};
  const double w = 2 * pi * frequency;
  for (Eigen::Index i = 0; i < kSamples; ++i) {
    const double theta = angle * std::sin(w * kStep * static_cast<double>(i));
    rotation.angle.col(i) << 0.5 * theta, theta, 0;
    rotation.acceleration.col(i) = (with_acceleration ? -w * w : 0.0) * rotation.angle.col(i);
  }
  return rotation;
}

FloorMotion still() { return FloorMotion(kStep, Eigen::Matrix3Xd::Zero(3, kSamples)); }

Scene standing_trolley() { return scene_of(scenes::trolley()); }

Response run(const Scene& scene, const FloorMotion& floor, double step = 0.004) {
  return simulate(scene, floor, scenes::run_for(8, step, 0.1));
}

// Gravity that the floor tilts is a force on every mass, as its translation is: with the angular
// acceleration left out, theta about y is the acceleration -g theta along x, and theta about x the
// acceleration g theta along y. The sums are the same but for the order of their terms, so what is
// left is rounding, some 1e-16 of m/s a step that later steps may amplify; 1e-9 m is a millionth of
// the motion.
TEST(FloorRotation, IsTheAccelerationThatTiltsGravityAlike) {
  const FloorRotation rotation = rocking(0.01, 0.5, false);
  Eigen::Matrix3Xd acceleration = Eigen::Matrix3Xd::Zero(3, kSamples);
  acceleration.row(0) = -kStandardGravity * rotation.angle.row(1);
  acceleration.row(1) = kStandardGravity * rotation.angle.row(0);
  const Response tilted = run(standing_trolley(), still().with_rotation(rotation));
  const Response shaken = run(standing_trolley(), FloorMotion(kStep, acceleration));
  ASSERT_GT(shaken.items[0].demands.peak_displacement, 1e-2);
  ASSERT_EQ(tilted.items[0].history.size(), shaken.items[0].history.size());
  for (std::size_t i = 0; i < tilted.items[0].history.size(); ++i) {
    const Sample &a = tilted.items[0].history[i], &b = shaken.items[0].history[i];
    EXPECT_LT((a.displacement - b.displacement).norm(), 1e-9) << a.time;
    EXPECT_NEAR(a.energy.work_of_floor, b.energy.work_of_floor, 1e-7) << a.time;
  }
}

// The absolute acceleration of a point leaves gravity out, so g theta is none. Stiff treads sway by
// (w / w_n)^2 = 1e-6 of it; they get their load with a jerk, w / w_n = 1e-3.
TEST(FloorRotation, AbsoluteAccelerationHasNoGravity) {
  scenes::ItemOptions options;
  scenes::stiffen(options.caster.tread);
  const Scene scene = scene_of(scenes::locked_block(options));
  const Response tilted = run(scene, still().with_rotation(rocking(0.01, 0.5, false)));
  EXPECT_LT(tilted.items[0].demands.points.at(0).peak_absolute_acceleration,
            0.01 * 0.01 * kStandardGravity);
}

// Works and losses come from their own forces; the geometry that a stage predicts misses them by
// the square of the step. The rotation does more work here than the shaking. Wheels of the locked
// block leave the floor and land, anywhere in a step: the order is that of the mean of motions.
TEST(FloorRotation, WorkIsInTheEnergyBalanceToSecondOrder) {
  for (const bool locked : {false, true}) {
    double of_coarse = 0, of_fine = 0;
    for (unsigned seed = 1; seed <= 8; ++seed) {
      const FloorMotion shaken = small::noise_record(seed, 6, {0.2, 0.1, 0.1});
      const FloorMotion floor = shaken.with_rotation(rocking(0.02, 2, true));
      Scene scene = scene_of(locked ? scenes::locked_block() : scenes::trolley());
      scene.items[0].initial.position = {2, 1, 0};
      // Steps at which kinks that stay inside them are below the rest.
      const Response coarse = run(scene, floor, 0.002), fine = run(scene, floor, 0.001);
      EXPECT_NE(coarse.outcome, Outcome::kUntrusted);
      EXPECT_GT(std::abs(coarse.items[0].energy.work_of_floor), 0.1) << locked;
      of_coarse += coarse.quality.energy_closure;
      of_fine += fine.quality.energy_closure;
    }
    EXPECT_LT(of_fine, 0.3 * of_coarse) << locked;
  }
}

// The axes of the rotation pass through the origin: far from it the floor goes up and down. The
// centre of mass of a block 2 m along x moves by -theta'' x vertically.
TEST(FloorRotation, CarriesWhatStandsAwayFromItsAxis) {
  Scene scene = scene_of({});
  scenes::ItemOptions options;
  scenes::stiffen(options.caster.tread);
  scene.items[0].model = scenes::locked_block(options);
  scene.items[0].initial.position = {2, 0, 0};
  const double angle = 0.005, w = 2 * pi;
  const Response response = run(scene, still().with_rotation(rocking(angle, 1, true)), 0.002);
  const double x = 2 + scene.items[0].model.marked_points[0].position.x();
  for (const Sample& s : response.items[0].history) {
    if (s.time <= 0 || s.time > 5.9) continue;
    // A sine between samples 0.01 s apart is low by (w dt)^2 / 8 = 5e-4 of its peak.
    EXPECT_NEAR(s.points[0].absolute_acceleration.z(), w * w * angle * std::sin(w * s.time) * x,
                2e-3 * w * w * angle * x)
        << s.time;
  }
}

// Under theta = theta_0 (1 - cos(w t)) about the vertical a block without friction stays where it is: seen
// from the floor it turns by -theta and goes from r to R(-theta) r. The engine neglects Coriolis and centrifugal
// acceleration, together -theta'^2 r here, whose double integral is -E r with
//   E = (theta_0 w)^2 (t^2 / 4 - sin^2(w t) / (4 w^2)).
// One that sticks goes with the floor.
TEST(FloorRotation, YawCarriesWhatSticksAndNothingElse) {
  const double angle = 0.005, w = 2 * pi;
  FloorRotation yaw{Eigen::Matrix3Xd::Zero(3, kSamples), Eigen::Matrix3Xd::Zero(3, kSamples)};
  for (Eigen::Index i = 0; i < kSamples; ++i) {
    const double phase = w * kStep * static_cast<double>(i);
    yaw.angle(2, i) = angle * (1 - std::cos(phase));
    yaw.acceleration(2, i) = angle * w * w * std::cos(phase);
  }
  for (const double friction : {0.0, 0.8}) {
    Scene scene = blocks::block(100, {0.5, 0.5, 0.5},
                                {.stiffness = 1e7, .restitution = 0.1, .friction = friction});
    scene.items[0].initial.position = {2, 1, 0};
    const Response response = run(scene, still().with_rotation(yaw), 0.002);
    const double left = friction > 0 ? 0 : 1;
    // Straight lines between samples miss a cosine by (w dt)^2 / 12 = 3e-4 of its peak; what sticks gives
    // way by m a / k, 2e-6 m, and turns by as much over its half width.
    for (const Sample& s : response.items[0].history) {
      // Later the neglected acceleration by E' itself counts: 2 theta_0 E' t, 1e-5 m here.
      if (s.time > (friction > 0 ? 5.9 : 1.5)) continue;
      const double theta = angle * (1 - std::cos(w * s.time));
      const double sine = std::sin(w * s.time) / (2 * w);
      const double E = angle * angle * w * w * (s.time * s.time / 4 - sine * sine);
      const double x = 2 * (std::cos(theta) - 1) + std::sin(theta) + 2 * E;
      const double y = -2 * std::sin(theta) + (std::cos(theta) - 1) + E;
      EXPECT_NEAR(s.yaw, -left * theta, 2e-3 * angle) << s.time;
      EXPECT_NEAR(s.displacement.x(), left * x, 4e-3 * angle) << s.time;
      EXPECT_NEAR(s.displacement.y(), left * y, 4e-3 * angle) << s.time;
    }
  }
}

TEST(FloorRotation, OfZeroChangesNoBit) {
  const FloorMotion shaken = small::noise_record(3, 5, {3, 2, 1});
  const auto samples = shaken.acceleration().cols();
  const FloorRotation none{Eigen::Matrix3Xd::Zero(3, samples), Eigen::Matrix3Xd::Zero(3, samples)};
  const Response with = run(standing_trolley(), shaken.with_rotation(none));
  const Response without = run(standing_trolley(), shaken);
  EXPECT_EQ(with.items[0].demands.residual_displacement,
            without.items[0].demands.residual_displacement);
  EXPECT_EQ(with.items[0].demands.peak_displacement, without.items[0].demands.peak_displacement);
}

TEST(FloorRotation, TheBaselinesRefuseIt) {
  const FloorMotion floor = still().with_rotation(rocking(0.01, 1, true));
  const RunOptions options{scenes::run_for(1, 0.004), Solver::kBullet};
  EXPECT_EQ(
      error_text([&] { gurney::run(standing_trolley(), floor, options); }),
      "the stock Bullet baselines know no rotation of the floor; use solver = \"implicit\" for "
      "this job");
}

}  // namespace
}  // namespace gurney
