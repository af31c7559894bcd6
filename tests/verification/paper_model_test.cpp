#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/units.h"
#include "engine/run/run.h"
#include "studies/verification/scenes/scenes.h"
#include "tests/support/error_text.h"

// The baseline that is the model of Xu, Ma & Kurata 2022 (engine/baselines/paper_model.h) on a pull
// with a constant force, against Newton's law (pulling_test.cpp). Its errors are numbers that
// docs/pulling_tests.md states; a baseline that got better or worse by itself would be another one.
namespace gurney {
namespace {

using namespace scenes;

constexpr double kForce = 40, kPull = 3, kResistance = 0.02;

struct Pull {
  Scene scene = scene_of({});
  double release = 0, rest = 0, stop = 0;  // in closed form

  Pull() {
    ItemOptions options;
    options.caster.tread.rolling_friction_length = kResistance * options.caster.wheel_radius;
    scene.items[0].model = trolley(options);
    scene.items[0].loads = {constant_force(kForce, kPull, {0.55, 0, 0.14})};
    const double mass = total_mass(scene.items[0].model);
    const double inertia = mass + wheel_inertia_mass(scene.items[0].model);
    const double resistance = kResistance * mass * kStandardGravity;
    const double a1 = (kForce - resistance) / inertia, a2 = resistance / inertia;
    const double v = a1 * kPull;
    release = v * kPull / 2;
    stop = kPull + v / a2;
    rest = release + v * v / (2 * a2);
  }

  Response run(Solver solver, double step) const {
    return gurney::run(scene, {}, {run_for(stop + 1, step, step), solver});
  }
  static double at_release(const Response& response) {
    for (const Sample& s : response.items[0].history)
      if (s.time > kPull - 1e-9) return s.displacement.x();
    return NAN;
  }
  static double at_rest(const Response& response) {
    return response.items[0].demands.residual_displacement_x;
  }
};

// First order in the step: 1 % at 5 ms is the position drift h v / 2 of semi-implicit Euler, over
// the distance v T / 2, h / T = 0.2 %, and what the lag of N and the hinges' correction add.
TEST(PaperModel, ComesToTheClosedFormAsTheStepGoesToZero) {
  const Pull pull;
  for (const auto& [step, tolerance] : {std::pair{0.005, 0.02}, {0.00125, 0.005}}) {
    SCOPED_TRACE(step);
    const Response response = pull.run(Solver::kBulletPaperDantzig, step);
    EXPECT_NEAR(pull.at_release(response), pull.release, tolerance * pull.release);
    EXPECT_NEAR(pull.at_rest(response), pull.rest, tolerance * pull.rest);
    EXPECT_NEAR(response.items[0].demands.residual_displacement_y, 0, 0.01 * pull.rest);
  }
}

TEST(PaperModel, AtTheStepOfGamesItIsWrongByPercents) {
  const Pull pull;
  const double error = pull.at_rest(pull.run(Solver::kBulletPaperDantzig, 0.02)) / pull.rest - 1;
  EXPECT_GT(std::abs(error), 0.03);
  EXPECT_LT(std::abs(error), 0.15);
}

// 25 kg on a wheel of 0.25 kg through hinges of rigid bodies: 50 sweeps are far from enough (5000
// come within 5 %).
TEST(PaperModel, SequentialImpulseDoesNotConverge) {
  const Pull pull;
  const Response response = pull.run(Solver::kBulletPaper, 0.005);
  EXPECT_GT(pull.at_rest(response), 1.5 * pull.rest);
}

// The wheels carry the weight: the force against the motion uses the right N.
TEST(PaperModel, WheelsCarryTheWeight) {
  const Pull pull;
  const Response response = pull.run(Solver::kBulletPaperDantzig, 0.0025);
  const double weight = total_mass(pull.scene.items[0].model) * kStandardGravity;
  double mean = 0, samples = 0;
  for (const Sample& s : response.items[0].history)
    if (s.time > 1) {
      for (std::size_t i = 0; i < 4; ++i) mean += s.wheels[i].normal_force;
      ++samples;
    }
  EXPECT_NEAR(mean / samples, weight, 0.01 * weight);
}

// A force against the motion has no state of rest: 1 s after it should rest, the trolley still
// moves, by less than what the force gives it in one step, a_2 h = 0.5 mm/s.
TEST(PaperModel, ChattersWhereItShouldRest) {
  const Pull pull;
  const Response response = pull.run(Solver::kBulletPaperDantzig, 0.0025);
  const double speed = std::abs(response.items[0].history.back().velocity.x());
  EXPECT_GT(speed, 0);
  EXPECT_LT(speed, 5e-4);
}

// Casters crosswise swing into line, as those of ours do.
TEST(PaperModel, CastersSwingIntoLine) {
  Pull pull;
  for (std::size_t i = 0; i < 4; ++i)
    pull.scene.items[0].model.casters[i].heading = (i % 2 == 0 ? 90 : -90) * kRadiansPerDegree;
  const Response response = pull.run(Solver::kBulletPaperDantzig, 0.0025);
  const Sample& last = response.items[0].history.back();
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(last.wheels[i].swivel_angle, 0, 0.2) << "caster " << i;
  EXPECT_GT(last.displacement.x(), 0.5 * pull.rest);
}

TEST(PaperModel, RefusesBrakesAndDropWeights) {
  Pull pull;
  pull.scene.items[0].loads = {DropWeight{.mass = 5, .drop_height = 1}};
  EXPECT_EQ(error_text([&] { pull.run(Solver::kBulletPaper, 0.005); }),
            "the stock Bullet baselines know no drop weights, blocks or fixtures; use solver = "
            "\"implicit\" for this job");
  pull.scene.items[0].loads.clear();
  pull.scene.items[0].model.casters[1].name = "front right";
  pull.scene.items[0].model.casters[1].brake_torque = 10;
  EXPECT_EQ(
      error_text([&] { pull.run(Solver::kBulletPaper, 0.005); }),
      "caster 'front right': the model of the paper (solver = \"bullet-paper\") has no brakes "
      "and no swivel locks; use solver = \"implicit\" for this job");
}

}  // namespace
}  // namespace gurney
