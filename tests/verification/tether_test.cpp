#include <gtest/gtest.h>

#include "engine/run/simulate.h"
#include "studies/verification/scenes/blocks.h"

// What cords do is a case of `gurney verify cord weak_cord`.
namespace gurney {
namespace {

TEST(Tether, MustReachItsAnchor) {
  Scene scene = blocks::block(50, {0.4, 0.4, 0.5}, {.friction = 0});
  scene.tethers = {{.name = "cord", .point = {-0.2, 0, 0.25}, .anchor = {-1.2, 0, 0.25}}};
  scene.tethers[0].stiffness = 500;
  scene.tethers[0].slack_length = 1.2;
  EXPECT_NO_THROW(simulate(scene, {}, blocks::run_for(0.1, 0.004, 0.1)));
  scene.tethers[0].slack_length = 0.9;
  EXPECT_ANY_THROW(simulate(scene, {}, blocks::run_for(0.1, 0.004, 0.1)));
}

/// A block of 50 kg on ice, 1 m from the anchor of a slack cord that pulls with 2 N, moves by
/// (2 N / 50 kg) t^2 / 2 = 0.02 m in 1 s. The force is constant, so that steps are exact but for
/// the rounding of some 250 of them. The cord itself never gets taut.
TEST(Tether, PullsHorizontallyWhileSlack) {
  Scene scene = blocks::block(50, {0.4, 0.4, 0.5}, {.friction = 0});
  scene.tethers = {{.name = "cord", .point = {0, 0, 0.25}, .anchor = {-1, 0, 0.25}}};
  scene.tethers[0].stiffness = 500;
  scene.tethers[0].slack_length = 1.2;
  scene.tethers[0].slack_pull = 2;
  const Response response = simulate(scene, {}, blocks::run_for(1, 0.004, 1));
  const auto& history = response.items[0].history;
  EXPECT_NEAR(history.back().displacement.x(), -0.02, 1e-6);
  EXPECT_LT(response.tethers.at(0).time_taut, 0);
  EXPECT_LT(response.quality.energy_closure, 1e-6);
}

}  // namespace
}  // namespace gurney
