#include "studies/verification/cases/drop_weight.h"

#include <gtest/gtest.h>

#include <vector>

#include "engine/run/simulate.h"

// What the closed forms of studies/verification/cases/drop_weight.cpp do not say.
namespace gurney {
namespace {

using namespace scenes;
using namespace verification::rig;

// Releases at times whose multiples of the step round up: 175 x 0.004 s > 0.7 s in binary. The
// blocks must hold to the end of that step, so the motion since the release is always the same.
TEST(DropWeightEvent, BlocksHoldUntilTheirTime) {
  const Rig rig{5, 0.7, 0.02};
  Scene scene = scene_of(pulled_trolley(rig, 3e8));
  std::vector<double> travelled;
  for (const double release : {0.696, 0.7, 0.704, 1.404}) {
    scene.items[0].loads = rigged(rig);
    scene.items[0].fixture = hold_rotations(false, true, false);
    std::get<Blocks>(scene.items[0].loads.back()).release_time = release;
    const auto response = simulate(scene, {}, run_for(release + 1, 0.004));
    travelled.push_back(response.items[0].demands.residual_displacement_x);
  }
  for (double x : travelled) EXPECT_NEAR(x, travelled[0], 1e-6 * travelled[0]);
}

// In the floor's frame a steady upward acceleration of the floor is more gravity, for weights too.
TEST(DropWeightEvent, VerticalFloorAccelerationIsGravity) {
  const Rig rig{5, 0.7, 0.02};
  Scene scene = scene_of(pulled_trolley(rig, 3e8));
  scene.items[0].loads = rigged(rig);
  scene.items[0].loads.pop_back();  // the blocks
  scene.items[0].fixture = hold_rotations(false, true, false);
  Scene heavy = scene;
  heavy.gravity += 2;
  const double expected =
      simulate(heavy, {}, run_for(1.5, 0.004)).items[0].demands.residual_displacement_x;
  const FloorMotion floor = floor_motion(0.01, 3, Vector3::UnitZ(), [](double) { return 2.0; });
  const auto response = simulate(scene, floor, run_for(1.5, 0.004));
  // The floor starts at once, so the treads sink and swing a little; their mean load is the same.
  EXPECT_NEAR(response.items[0].demands.residual_displacement_x, expected, 1e-3 * expected);
  EXPECT_LT(response.quality.energy_closure, 1e-4);
}

}  // namespace
}  // namespace gurney
