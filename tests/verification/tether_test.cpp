#include <gtest/gtest.h>

#include <algorithm>

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

/// A block of 40 kg that slides at 1 m/s into a cord with damping, whose tension jumps from c v on.
struct Snatch {
  double stiffness = 2000, damping = 300, mass = 40, speed = 1, slack = 0.05;

  double tension(double stretched, double rate) const {
    const double elastic = stiffness * stretched;
    return elastic > 0 ? elastic + std::clamp(damping * rate, -elastic, elastic) : 0;
  }
  /// Time at which the tension is that, by steps of 1 us whose error is 1e-6 of the motion.
  double time_of(double strength) const {
    constexpr double kStep = 1e-6;
    double x = 0, v = speed, time = 0;
    for (; tension(x - slack, v) < strength; time += kStep) {
      v -= kStep / mass * tension(x - slack, v);
      x += kStep * v;
    }
    return time;
  }
};

/// The largest tension is the strength to a stretch of 1 nm whatever the step. With omega^2 = 2 k / m, as stiff as the
/// law gets, a method of second order errs by (omega dt)^2 of the motion since the cord got taut, and by the kink within
/// one step; the reference by its own step. Breaking at the end of a step would be late by half of one, 2 ms.
TEST(Tether, BreaksWhenDampingAndSpringTogetherReachItsStrength) {
  const Snatch snatch;
  Scene scene = blocks::block(snatch.mass, {0.4, 0.4, 0.5}, {.friction = 0});
  scene.items[0].initial.velocity.x() = snatch.speed;
  scene.tethers = {{.name = "cord", .point = {-0.2, 0, 0.25}, .anchor = {-1.2, 0, 0.25}}};
  Tether& cord = scene.tethers[0];
  cord.stiffness = snatch.stiffness, cord.damping = snatch.damping;
  cord.slack_length = 1 + snatch.slack;
  for (const double strength : {60.0, 210.0, 280.0})
    for (const double step : {0.004, 0.00025}) {
      cord.strength = strength;
      const Response response = simulate(scene, {}, blocks::run_for(0.4, step, 0.4));
      const TetherOutcome& outcome = response.tethers.at(0);
      EXPECT_NEAR(outcome.peak_tension, strength, 1e-9 * snatch.stiffness) << step;
      const double expected = snatch.time_of(strength), taut = snatch.slack / snatch.speed;
      const double error = 2 * snatch.stiffness / snatch.mass * step * step;
      EXPECT_NEAR(outcome.time_broken, expected, error * (expected - taut + step) + 1e-6) << step;
      EXPECT_LT(response.quality.energy_closure, 0.01);
    }
}

}  // namespace
}  // namespace gurney
