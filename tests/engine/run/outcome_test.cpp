#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/error.h"
#include "engine/record/energy_balance.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/small_scenes.h"
#include "tests/engine/run/drawn_items.h"
#include "tests/support/error_text.h"

namespace gurney {
namespace {

struct Job {
  Scene scene = scene_of({});
  FloorMotion floor;
  SimulationSettings settings;
};

Job coasting(double rolling_resistance) {
  Job job;
  Tread tread;
  tread.rolling_friction_length = rolling_resistance;
  tread.tangential_damping = 500;
  job.scene.items[0].model = small::trolley({0, 0, 0, 0}, tread);
  job.scene.items[0].initial.velocity = {0.3, 0, 0};
  return job;
}

Response run(const Job& job) { return simulate(job.scene, job.floor, job.settings); }

bool finite(const Response& response) {
  bool all = std::isfinite(response.items[0].demands.peak_displacement) &&
             std::isfinite(response.items[0].demands.peak_normal_force) &&
             std::isfinite(response.items[0].demands.residual_yaw) &&
             std::isfinite(response.items[0].energy.loss()) &&
             std::isfinite(response.quality.energy_closure) &&
             std::isfinite(response.quality.largest_residual);
  for (const Sample& sample : response.items[0].history)
    all &= sample.displacement.allFinite() && sample.velocity.allFinite() &&
           sample.acceleration.allFinite() && std::isfinite(sample.energy.stored());
  return all;
}

TEST(Outcome, AnItemThatComesToRestHasRested) {
  // 0.3 m/s against Cr / R g = 0.196 m/s2 stops after 1.53 s; the chassis then sways on its stuck
  // treads (0.3 s here), and rest must hold for 0.5 s.
  const Job job = coasting(1e-3);
  const Response response = run(job);
  EXPECT_EQ(response.outcome, Outcome::kRested);
  EXPECT_GT(response.end_time, 1.53 + 0.5);
  EXPECT_LT(response.end_time, 1.53 + 0.5 + 0.5);
  EXPECT_LT(response.items[0].history.back().velocity.norm(), job.settings.rest_speed);
  EXPECT_NEAR(response.items[0].history.back().time, response.end_time, 1e-9) << "the end is kept";
  EXPECT_EQ(response.cause, "");
  EXPECT_TRUE(finite(response));
  EXPECT_GT(response.quality.largest_residual, 0) << "the worst step, not the best";
  EXPECT_LE(response.quality.largest_residual, job.settings.residual);
}

TEST(Outcome, AnItemThatNeverRestsIsStillMovingAfterTheSettleTime) {
  Job job = coasting(0);
  job.settings.settle_time = 2;
  const Response response = run(job);
  EXPECT_EQ(response.outcome, Outcome::kStillMoving);
  EXPECT_NEAR(response.end_time, 2, 1e-9);
}

TEST(Outcome, AGivenDurationStopsTheRunRestingOrNot) {
  Job job = coasting(1e-3);
  job.settings.duration = 3;
  EXPECT_EQ(run(job).outcome, Outcome::kStopped);
  EXPECT_NEAR(run(job).end_time, 3, 1e-9);
}

TEST(Outcome, AnItemPushedOverHasOverturned) {
  Job job = coasting(1e-3);
  job.scene.items[0].initial.velocity.setZero();
  job.scene.items[0].loads = {
      PointForce{"push", {0, 0, 1.0}, {0, 1, 0}, {0, 0.2, 3}, {0, 900, 900}}};
  for (Caster& c : job.scene.items[0].model.casters) {
    c.swivels = false;  // and cannot roll sideways
    c.tread.static_friction = c.tread.kinetic_friction = 2;
  }
  const Response response = run(job);
  EXPECT_EQ(response.outcome, Outcome::kOverturned) << response.cause;
  EXPECT_LT(response.items[0].demands.time_of_overturning, response.end_time) << "followed to rest";
  EXPECT_LT(response.end_time, 12);
  EXPECT_GT(response.items[0].history.back().tilt, 1.4) << "lies on its side";
  EXPECT_GE(response.items[0].demands.impacts, 1);
  EXPECT_LT(response.quality.energy_closure, 0.01);
  SimulationSettings& settings = job.settings;
  settings.follow_overturning = false;
  const Response cut = run(job);
  EXPECT_EQ(cut.items[0].demands.time_of_overturning,
            response.items[0].demands.time_of_overturning);
  EXPECT_EQ(cut.end_time, cut.items[0].demands.time_of_overturning);
  EXPECT_GT(response.items[0].demands.peak_tilt, job.settings.overturn_tilt);
  EXPECT_GE(response.items[0].demands.most_wheels_lifted, 2);
  EXPECT_GT(response.items[0].demands.wheels[1].liftoffs, 0);
  EXPECT_TRUE(finite(response));
}

TEST(Outcome, ARunThatCannotGoOnSaysWhyAndHoldsNoNaN) {
  // A floor acceleration that no step of this length resolves.
  Job job = coasting(1e-3);
  Eigen::Matrix3Xd acceleration = Eigen::Matrix3Xd::Zero(3, 40);
  for (int i = 10; i < 40; ++i) acceleration(i % 3, i) = (i % 2 ? 1 : -1) * 1e200;
  job.floor = FloorMotion(0.01, acceleration);
  const Response response = run(job);
  EXPECT_EQ(response.outcome, Outcome::kDiverged);
  EXPECT_NE(response.cause, "");
  EXPECT_TRUE(finite(response));
}

// The kinds of numbers that a file may hold and no physics resolves.
TEST(Outcome, FiniteHugeNumbersFailByName) {
  Job job = coasting(1e-3);
  job.scene.items[0].loads = {PointForce{"push", {0, 0, 1.0}, {0, 1, 0}, {0, 0.2}, {1e300, 1e300}}};
  EXPECT_EQ(run(job).outcome, Outcome::kDiverged);
  job = coasting(1e-3);
  RoomShape kerb;
  kerb.name = "kerb";
  kerb.position = {2, 0, 0.01};
  for (const double width : {5e-324, 1e308}) {
    kerb.shape = RoomBox{Vector3(width, 1, 0.02)};
    job.scene.room = {kerb};
    try {
      EXPECT_TRUE(finite(run(job))) << width;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("has no faces")) << width;
    }
  }
}

/// Treads so stiff that the item rattles within each step of 8 ms. Its balance is off by 0.7.
/// At steps that do not resolve its contacts.
drawn::Run coarse(unsigned seed, double step) {
  drawn::Run run = drawn::run(seed);
  run.settings.time_step = step;
  return run;
}

drawn::Run rattling() { return coarse(1054, 0.008); }

// Half the step from there on resolves it, and nothing before changes.
TEST(Outcome, ARunThatFailsAfterTheOverturningHasShorterStepsFromThere) {
  for (drawn::Run run : {rattling(), coarse(1552, 0.016)}) {
    const Response response = simulate(run.scene, run.floor, run.settings);
    EXPECT_EQ(response.outcome, Outcome::kOverturned);
    EXPECT_EQ(response.cause, "");
    EXPECT_LE(response.quality.energy_closure, EnergyBalance::kTrusted);
    run.settings.follow_overturning = false;
    const Response until_then = simulate(run.scene, run.floor, run.settings);
    EXPECT_GT(response.end_time, until_then.end_time);
    EXPECT_EQ(response.items[0].demands.time_of_overturning,
              until_then.items[0].demands.time_of_overturning);
  }
}

/// A push at 3 s that no step resolves.
void push_beyond_all(Scene& scene) {
  scene.items[0].loads.push_back(
      PointForce{"push", {0, 0, 0.1}, {0, 1, 0}, {3, 3.2}, {1e300, 1e300}});
}

TEST(Outcome, WhatNoStepResolvesEndsAtTheOverturning) {
  drawn::Run run = rattling();
  push_beyond_all(run.scene);
  const Response response = simulate(run.scene, run.floor, run.settings);
  EXPECT_EQ(response.outcome, Outcome::kOverturned);
  EXPECT_THAT(response.cause,
              testing::StartsWith("ends where it overturned at 2.3 s: what followed "));
  EXPECT_LE(response.quality.energy_closure, EnergyBalance::kTrusted);
  run.settings.follow_overturning = false;
  const Response until_then = simulate(run.scene, run.floor, run.settings);
  EXPECT_EQ(until_then.cause, "");
  EXPECT_EQ(response.end_time, until_then.end_time);
  EXPECT_EQ(response.items[0].demands.peak_displacement,
            until_then.items[0].demands.peak_displacement);
}

TEST(Outcome, ARunWhoseEnergyBalanceMissesIsUntrusted) {
  const drawn::Run run = coarse(1369, 0.02);
  const Response response = simulate(run.scene, run.floor, run.settings);
  EXPECT_EQ(response.outcome, Outcome::kUntrusted);
  EXPECT_TRUE(is_failure(response.outcome));
  EXPECT_THAT(response.cause, testing::StartsWith("the energy balance of item is off by 0."));
  EXPECT_THAT(response.cause, testing::HasSubstr("above the limit of 0.05"));
}

// What the other item does after the first has overturned is not cut off: its demands would be too small.
TEST(Outcome, ARunOfSeveralItemsDoesNotEndWhereOneOverturned) {
  drawn::Run run = coarse(1512, 0.02);
  run.scene.items.push_back(coasting(1e-3).scene.items[0]);
  run.scene.items[1].name = "coasting";
  run.scene.items[1].initial.position = {50, 0, 0};
  EXPECT_EQ(simulate(run.scene, run.floor, run.settings).outcome, Outcome::kOverturned);
  push_beyond_all(run.scene);
  const Response response = simulate(run.scene, run.floor, run.settings);
  EXPECT_EQ(response.outcome, Outcome::kDiverged);
  EXPECT_THAT(response.cause,
              testing::EndsWith("within the limit until item overturned at 2.88 s, where "
                                "settings.follow_overturning = false ends the run"));
  EXPECT_GT(response.end_time, 2.88);
}

// Replays keep histories and must come to the same verdict.
TEST(Outcome, TheVerdictDoesNotDependOnTheHistory) {
  drawn::Run run = rattling();
  run.settings.history_step = 0;
  const Response without = simulate(run.scene, run.floor, run.settings);
  run.settings.history_step = 0.008;
  const Response with = simulate(run.scene, run.floor, run.settings);
  EXPECT_EQ(without.outcome, with.outcome);
  EXPECT_EQ(without.cause, with.cause);
}

TEST(Outcome, WrongScenesAndSettingsAreErrorsNotOutcomes) {
  Job job = coasting(1e-3);
  job.settings.time_step = 0.5;
  EXPECT_EQ(error_text([&] { run(job); }), "settings: time_step = 0.5: must be > 0 and <= 0.02 s");
  job = coasting(1e-3);
  job.scene.items[0].model.chassis_mass = -1;
  EXPECT_EQ(error_text([&] { run(job); }),
            "item 'item': chassis_mass = -1: must be > 0 and finite");
}

TEST(Outcome, NamesAreStable) {
  EXPECT_STREQ(name_of(Outcome::kRested), "rested");
  EXPECT_STREQ(name_of(Outcome::kOverturned), "overturned");
  EXPECT_STREQ(name_of(Outcome::kDiverged), "diverged");
  EXPECT_STREQ(name_of(Outcome::kUntrusted), "untrusted");
  EXPECT_TRUE(is_failure("untrusted") && is_failure("diverged") && !is_failure("overturned"));
}

}  // namespace
}  // namespace gurney
