#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/response/settled.h"
#include "engine/run/refine.h"
#include "engine/run/run.h"
#include "engine/run/simulate.h"
#include "engine/run/twin.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

namespace gurney {
namespace {

using Verdict = Predictability::Verdict;

constexpr double kSpacing = 0.02, kEnd = 6;  // [s]

/// A run that moves as sin(t / 4), and a twin that parts from it by 1e-9 exp(rate t) of its peak.
Response moving(double rate, double peak_time, bool twin) {
  Response response;
  ItemResponse& item = response.items.emplace_back();
  item.demands.peak_displacement = 0.5;
  item.demands.time_of_peak_displacement = peak_time;
  for (int k = 0; k * kSpacing <= kEnd; ++k) {
    Sample sample;
    sample.time = k * kSpacing;
    const double parted = twin ? 0.5e-9 * std::exp(rate * sample.time) : 0;
    sample.displacement.x() = 0.5 * std::sin(sample.time / 4) + parted;
    item.history.push_back(sample);
  }
  return response;
}

Predictability compared(double rate, double peak_time) {
  return compare_twin(moving(rate, peak_time, false), moving(rate, peak_time, true)).at(0);
}

TEST(Predictability, EndsWhereAKnownGrowthReachesAThousand) {
  // exp(5 t) is 1e3 at 1.382 s, 1e7 at 3.224 s; the horizon is the next sample.
  const Predictability late = compared(5, 4);
  EXPECT_EQ(late.verdict, Verdict::kChaotic);
  EXPECT_NEAR(late.horizon, std::log(1e3) / 5 + kSpacing / 2, kSpacing / 2);
  EXPECT_EQ(compared(5, 2).verdict, Verdict::kSensitive);
  const Predictability early = compared(5, 1);
  EXPECT_EQ(early.verdict, Verdict::kPredictable) << "its peak is before the horizon";
  // Differences of numbers near 0.5 are rounded to 1e-16, 1e-7 of the change.
  EXPECT_NEAR(early.amplification_at_peaks, std::exp(5), 1e-6 * std::exp(5));
  EXPECT_NEAR(early.amplification, std::exp(5 * kEnd), 1e-6 * std::exp(5 * kEnd));
  EXPECT_EQ(early.horizon, late.horizon);
}

TEST(Predictability, HasNoEndWithoutGrowth) {
  const Predictability steady = compared(0, 4);
  EXPECT_EQ(steady.verdict, Verdict::kPredictable);
  EXPECT_TRUE(std::isnan(steady.horizon));
  EXPECT_NEAR(steady.amplification, 1, 1e-6);
}

TEST(Predictability, IsChaoticWhereOnlyOneOverturns) {
  Response run = moving(0, 4, false), twin = moving(0, 4, true);
  twin.items[0].demands.time_of_overturning = 3;
  EXPECT_EQ(compare_twin(run, twin)[0].verdict, Verdict::kChaotic);
  run.items[0].demands.time_of_overturning = 3;
  const Predictability both = compare_twin(run, twin)[0];
  EXPECT_EQ(both.verdict, Verdict::kPredictable);
  EXPECT_EQ(both.time_of_peaks, 3) << "what follows an overturning is not asked";
}

TEST(Predictability, ATwinThatRestsEarlierStaysWhereItIs) {
  Response run = moving(0, 4, false), twin = moving(0, 4, true);
  twin.items[0].history.resize(200);
  // Since 3.98 s the run has moved on to 0.5 (sin(1.5) - sin(0.995)), that over 0.5 and 1e-9.
  EXPECT_NEAR(compare_twin(run, twin)[0].amplification, 1e9 * (std::sin(1.5) - std::sin(0.995)), 2);
}

Predictability of(const Scene& scene, const FloorMotion& floor) {
  const SimulationSettings settings;
  return predictability(scene, floor, settings, simulate(scene, floor, settings)).at(0);
}

TEST(Predictability, OfATrolleyThatCoastsIsThatOfItsMass) {
  Tread tread;
  Scene scene = scene_of({});
  scene.items[0].model = small::trolley({0, 0, 0, 0}, tread);
  scene.items[0].initial.velocity = {0.3, 0, 0};
  const Predictability found = of(scene, {});
  EXPECT_EQ(found.verdict, Verdict::kPredictable);
  EXPECT_TRUE(std::isnan(found.horizon));
  // Its path v^2 / 2a, a = g Cr / R M / (M + J / R^2), changes by less than the mass does. The
  // residual of a stage, 1e-9 M g tau, over the resistance, Cr / R = 0.02 of M g tau, bounds what
  // the solver adds: 5e-8 of the path.
  EXPECT_LT(found.amplification, 1 + 50);
}

/// Brakes on, so tall that it rocks.
Scene braked_and_tall() {
  Scene scene = scene_of({});
  EquipmentModel& model = scene.items[0].model = small::trolley({0, 0, 0, 0}, Tread{});
  model.chassis_center_of_mass.z() = 1.1;
  for (Caster& caster : model.casters) caster.brake_torque = 100;
  return scene;
}

TEST(Predictability, OfABrakedItemThatRocksIsLost) {
  const Scene scene = braked_and_tall();
  // It rocks and stays upright: the balance of what lies on its casters may miss.
  const FloorMotion floor = small::noise_record(3, 12, {4.75, 3.8, 1.9});
  const SimulationSettings settings;
  const Response run = simulate(scene, floor, settings);
  ASSERT_GT(run.items[0].demands.most_wheels_lifted, 1) << "it must rock";
  const Predictability found = predictability(scene, floor, settings, run).at(0);
  EXPECT_NE(found.verdict, Verdict::kPredictable);
  EXPECT_GT(found.amplification, Predictability::kChaotic);
  // Another change that nobody can measure, and another motion at the end.
  Scene other = scene;
  other.items[0].model.chassis_mass *= 1 - 3e-9;
  const Response parted = simulate(other, floor, settings);
  const Vector3 apart =
      parted.items[0].history.back().displacement - run.items[0].history.back().displacement;
  EXPECT_GT(apart.norm(), 0.01 * run.items[0].demands.peak_displacement);
}

TEST(Predictability, NeedsNoHistoryOfTheRun) {
  const Scene scene = braked_and_tall();
  const FloorMotion floor = small::noise_record(3, 4, {5, 4, 2});
  SimulationSettings settings;
  const Predictability with =
      predictability(scene, floor, settings, simulate(scene, floor, settings)).at(0);
  settings.history_step = 0;
  const Predictability without =
      predictability(scene, floor, settings, simulate(scene, floor, settings)).at(0);
  EXPECT_EQ(without.amplification, with.amplification);
  EXPECT_EQ(without.time_of_peaks, with.time_of_peaks);
}

TEST(HalfStep, HasTheDemandsOfTheFinerRun) {
  const Scene scene = braked_and_tall();
  const FloorMotion floor = small::noise_record(3, 2, {5, 4, 2});
  const SimulationSettings settings{.time_step = 0.008, .tolerance = 0.1};
  SimulationSettings finer = settings;
  finer.time_step = 0.004;
  finer.tolerance = 0.1 / 8;  // of second order: errors of a step go with its cube
  std::vector<Predictability> found(1);
  add_half_step(scene, simulate(scene, floor, settings), half_step_run(scene, floor, settings),
                found);
  const Demands expected = simulate(scene, floor, finer).items[0].demands;
  EXPECT_GT(expected.peak_tilt, Predictability::kLeastTilt);
  ASSERT_TRUE(found[0].half_step);
  EXPECT_EQ(found[0].half_step->peak_displacement, expected.peak_displacement);
  EXPECT_EQ(found[0].half_step->peak_tilt, expected.peak_tilt);
  EXPECT_EQ(found[0].half_step->wheels[2].skid_distance, expected.wheels[2].skid_distance);
}

/// Two blocks, 1 m wide and `apart` from each other.
Scene two_blocks(double apart) {
  Scene scene = blocks::block(10, {1, 1, 1}, {});
  scene.items.push_back(scene.items[0]);
  scene.items[1].initial.position.x() = 1 + apart;
  return scene;
}

/// Labels of the first of two bodies, of which half the step moves the second by 5 cm and the first not at all.
std::vector<SettledDemand> beside_an_unsettled_block(const Scene& scene) {
  Response run;
  run.outcome = Outcome::kStopped;
  run.items.resize(2);
  run.items[0].demands.peak_displacement = run.items[1].demands.peak_displacement = 0.1;
  Response half = run;
  half.items[1].demands.peak_displacement = 0.15;
  std::vector<Predictability> found(2);
  for (Predictability& each : found) each.twin = run.items[0].demands;
  add_half_step(scene, run, half, found);
  run.items[0].predictability = found[0];
  return settled_demands(run.items[0]);
}

// Circles of radius sqrt(2) / 2 m about blocks that move 0.1 m each: they may meet if what is left, apart less
// 0.41 and 0.2 m, is within 4 times 0.05 m.
TEST(HalfStep, OfANeighbourThatMayBeMetIsThatOfTheItem) {
  const auto label = [](double apart, std::string_view name = "peak_displacement") {
    const std::vector<SettledDemand> all = beside_an_unsettled_block(two_blocks(apart));
    return std::ranges::find(
               all, name,
               [](const SettledDemand& each) { return std::string_view(each.number.name); })
        ->within();
  };
  EXPECT_EQ(label(0.83), 0.01);
  // A third of 0.15 m changes; a quarter of that times 4 is more than 10 %.
  EXPECT_GT(label(0.80), 0.1);
  EXPECT_EQ(label(0.83, "largest_approach_speed"), 0.01);
  EXPECT_GT(label(0.80, "largest_approach_speed"), 0.1) << "it may be hit";
}

TEST(HalfStep, OfAPartOfItsOwnMechanismIsNoNeighbours) {
  Scene scene = two_blocks(0);
  scene.joints.emplace_back().part = 1;
  for (const SettledDemand& each : beside_an_unsettled_block(scene))
    EXPECT_EQ(each.least_change, 0) << each.number.name;
}

/// Twin and half step of each way to choose the step, made one after the other.
Predictability judged_in_turn(const Scene& scene, const FloorMotion& floor,
                              const RunOptions& options, const Response& run) {
  const SimulationSettings settings = refined_settings(options, run.quality);
  std::vector<Predictability> found = predictability(scene, floor, settings, run);
  add_half_step(scene, run, half_step_run(scene, floor, settings), found);
  return found.at(0);
}

TEST(RunJudged, HasTheBitsOfItsPartsForAnyNumberOfThreads) {
  const Scene scene = braked_and_tall();
  const FloorMotion floor = small::noise_record(3, 2, {5, 4, 2});
  RunOptions fixed, tolerance, refined, bare;
  tolerance.tolerance = 0.1;
  refined.peak_error = 0.05;
  bare.history_step = 0;
  for (const RunOptions& options : {fixed, tolerance, refined, bare}) {
    const Response run = gurney::run(scene, floor, options);
    const Predictability expected = judged_in_turn(scene, floor, options, run);
    for (int threads : {1, 3}) {
      const Response judged = run_judged(scene, floor, options, threads).response;
      EXPECT_EQ(judged.items[0].demands.peak_tilt, run.items[0].demands.peak_tilt);
      EXPECT_EQ(judged.items[0].history.size(), run.items[0].history.size());
      ASSERT_TRUE(judged.items[0].predictability);
      const Predictability& found = *judged.items[0].predictability;
      EXPECT_EQ(found.amplification, expected.amplification);
      EXPECT_EQ(found.twin->peak_tilt, expected.twin->peak_tilt);
      EXPECT_EQ(found.half_step->peak_tilt, expected.half_step->peak_tilt);
      EXPECT_NE(found.half_step->peak_tilt, run.items[0].demands.peak_tilt);
    }
  }
}

TEST(RunJudged, JudgesNoBaselineAndNoRunThatFailed) {
  const FloorMotion floor = small::noise_record(3, 1, {2, 2, 1});
  RunOptions baseline;
  baseline.solver = Solver::kBullet;
  EXPECT_FALSE(run_judged(braked_and_tall(), floor, baseline, 2).response.items[0].predictability);
  // No step of this length resolves this floor.
  const Eigen::Matrix3Xd violent = Eigen::Matrix3Xd::Constant(3, 40, 1e200);
  const Response failed = run_judged(braked_and_tall(), {0.01, violent}, {}, 2).response;
  ASSERT_TRUE(is_failure(failed.outcome));
  EXPECT_FALSE(failed.items[0].predictability);
}

}  // namespace
}  // namespace gurney
