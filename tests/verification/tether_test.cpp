#include <gtest/gtest.h>

#include "engine/simulate.h"
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

}  // namespace
}  // namespace gurney
