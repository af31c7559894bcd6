#include "engine/run/refine.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/response/settled.h"
#include "engine/run/run.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/small_scenes.h"
#include "tests/support/error_text.h"

namespace gurney {
namespace {

Scene rolling() {
  Scene scene = scene_of({});
  scene.items[0].model = small::trolley({10, 100, 200, 300}, Tread{});
  return scene;
}

/// At 20 ms a motion of 1.5 Hz is coarse: peaks are off by percents.
Response refined(const Scene& scene, const FloorMotion& floor, const SimulationSettings& settings,
                 double peak_error) {
  return run(scene, floor, {settings, Solver::kImplicit, peak_error});
}

const SimulationSettings kCoarse = small::settings_for(0.02, 8);

SimulationSettings with_steps_times(double factor, SimulationSettings settings) {
  lengthen_steps(factor, settings);
  return settings;
}

const FloorMotion& floor_motion() {
  static const FloorMotion motion = small::noise_record(4, 6, {3, 2, 1});
  return motion;
}

TEST(Refine, HalvesTheStepUntilTheDemandsStay) {
  const Scene scene = rolling();
  const Response run = refined(scene, floor_motion(), kCoarse, 0.05);
  EXPECT_GE(run.quality.step_halvings, 2);
  EXPECT_LT(run.quality.step_halvings, Quality::kLargestHalvings);
  EXPECT_LE(run.quality.peak_change, 0.025);
  EXPECT_GT(run.quality.peak_change, 0);

  const SimulationSettings last = refined_settings(kCoarse, run.quality);
  EXPECT_EQ(last.time_step, 0.02 * std::pow(0.5, static_cast<double>(run.quality.step_halvings)));
  const Response same = simulate(scene, floor_motion(), last);
  EXPECT_EQ(run.items[0].demands.peak_displacement, same.items[0].demands.peak_displacement);
  const Response before = simulate(scene, floor_motion(), with_steps_times(2, last));
  const Response first = simulate(scene, floor_motion(), with_steps_times(4, last));
  EXPECT_EQ(run.quality.peak_change,
            std::max(demand_change(first.items[0].demands, before.items[0].demands),
                     demand_change(before.items[0].demands, same.items[0].demands)));
  // A change of at most half the error is 3/4 of it, or half of it at first order.
  const Response finest = simulate(scene, floor_motion(), with_steps_times(1.0 / 16, last));
  EXPECT_LE(demand_change(run.items[0].demands, finest.items[0].demands), 0.05);
}

TEST(Refine, TakesFewerStepsForALargerError) {
  const Scene scene = rolling();
  EXPECT_LT(refined(scene, floor_motion(), kCoarse, 0.1).quality.steps,
            refined(scene, floor_motion(), kCoarse, 0.002).quality.steps);
}

TEST(Refine, LeavesChaoticMotionAtItsStep) {
  Scene scene = rolling();
  EquipmentModel& model = scene.items[0].model;
  for (Caster& caster : model.casters) caster.brake_torque = 1e3;
  model.chassis_center_of_mass.z() = 1.2;
  const FloorMotion strong = small::noise_record(4, 20, {6, 4, 2});
  const SimulationSettings settings = small::settings_for(0.004, 24, 5);
  const Response run = refined(scene, strong, settings, 0.01);
  EXPECT_EQ(run.quality.step_halvings, 0);
  EXPECT_EQ(run.items[0].demands.peak_displacement,
            simulate(scene, strong, settings).items[0].demands.peak_displacement);
}

TEST(DemandChange, IsTheLargestOfThoseJudged) {
  Demands a, b;
  a.peak_displacement = 0.101;
  b.peak_displacement = 0.1;
  a.residual_yaw = 0.098;
  b.residual_yaw = 0.1;
  EXPECT_NEAR(demand_change(a, b), 0.02, 1e-15);
  std::vector<bool> judged(numbers_of(a).size(), true);
  judged[10] = false;
  EXPECT_STREQ(numbers_of(a)[10].name, "residual_yaw");
  EXPECT_NEAR(demand_change(a, b, judged), 0.001 / 0.101, 1e-15);
  b.time_of_overturning = 4;
  EXPECT_EQ(demand_change(a, b), std::numeric_limits<double>::infinity());
  a.time_of_overturning = 4.2;
  EXPECT_NEAR(demand_change(a, b), 0.2 / 4.2, 1e-15);
}

TEST(Refine, RefusesAnErrorOutsideItsRange) {
  for (const double error : {0.2, -0.1, std::nan("")})
    EXPECT_EQ(error_text([&] { refined(rolling(), floor_motion(), kCoarse, error); }),
              fmt::format("settings: peak_error = {}: must be in [0, 0.1]", error));
}

}  // namespace
}  // namespace gurney
