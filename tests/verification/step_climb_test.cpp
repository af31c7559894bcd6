#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/small_scenes.h"
#include "studies/verification/scenes/blocks.h"

// A wheel that is pushed against a step.
namespace gurney {
namespace {

struct Step {
  double radius, height;  // of the wheel, of the step [m]
};

class StepClimb : public testing::TestWithParam<Step> {};

/// Four rigid casters whose front wheels touch a step, pushed at the height of the axles.
Response pushed(const Step& step, double force) {
  Scene scene;
  Tread tread = small::bare_tread(1e7, 1e7);
  tread.normal_damping = 3e4;  // some 50 % of critical for a quarter of the mass: no rebound
  tread.tangential_damping = 1e3;
  scene.items[0].model = small::trolley({0, 0, 0, 0}, tread);
  double front = 0;
  for (Caster& caster : scene.items[0].model.casters) {
    caster.swivels = false;
    caster.trail = 0;
    const double change = step.radius - caster.wheel_radius;
    caster.wheel_radius = step.radius;
    caster.height += change;
    caster.mount.z() = caster.height;
    front = std::max(front, caster.mount.x());
  }
  // The step's edge is where the rim passes its height: sqrt(r^2 - (r - h)^2) before the axle.
  const double reach = std::sqrt(2 * step.radius * step.height - step.height * step.height);
  scene.room = {{"step",
                 "",
                 {front + reach + 0.5 + 1e-4, 0, step.height / 2},
                 Quaternion::Identity(),
                 RoomBox{{1, 4, step.height}}}};
  Excitation excitation;
  excitation.forces = {{"push", {-0.4, 0, step.radius}, Vector3::UnitX(), {0, 4}, {force, force}}};
  return simulate(scene, excitation, blocks::run_for(2, 1e-3, 1e-3));
}

// The wheel turns about the edge, (r - h) below its axle and sqrt(2 r h - h^2) ahead: it leaves the
// floor when F (r - h) = N sqrt(2 r h - h^2), which gets less as it rises. Push and edge meet in
// the axle, so the load N of the axle is that at rest: half of the weight on the trolley's even
// base.
TEST_P(StepClimb, NeedsThePushOfStatics) {
  const auto [r, h] = GetParam();
  constexpr double kMass = 96.5;
  const double load = kMass * kStandardGravity / 2;
  const double force = load * std::sqrt(2 * r * h - h * h) / (r - h);
  // Treads of 1e7 N/m yield 25 to 50 um, which turns the line from the edge to the axle by 1e-3.
  const Response below = pushed(GetParam(), 0.99 * force);
  const Response above = pushed(GetParam(), 1.01 * force);
  for (const Response& response : {below, above}) {
    ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
    EXPECT_LT(response.quality.energy_closure, 0.003);
    EXPECT_EQ(response.quality.unconverged_steps, 0);
  }
  EXPECT_LT(below.items[0].demands.peak_displacement, 1e-3);
  EXPECT_GT(above.items[0].demands.peak_displacement, 1);
}

INSTANTIATE_TEST_SUITE_P(Steps, StepClimb,
                         testing::Values(Step{0.05, 0.01}, Step{0.05, 0.02}, Step{0.075, 0.02},
                                         Step{0.0375, 0.01}, Step{0.025, 0.01}));

}  // namespace
}  // namespace gurney
