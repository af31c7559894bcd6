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

/// Two blocks on ice whose middles a cord joins that is slack by 0.1 m; the second slides away from the first.
struct TwoBlocks {
  double m1 = 30, m2 = 20, speed = 1, stiffness = 2000;
  Scene scene = blocks::block(m1, {0.4, 0.4, 0.5}, {.friction = 0});

  TwoBlocks() {
    scene.items[0].name = "first";
    scene.items.push_back(blocks::block(m2, {0.4, 0.4, 0.5}, {.friction = 0}).items[0]);
    scene.items[1].name = "second";
    scene.items[1].initial.position = {1, 0, 0};
    scene.items[1].initial.velocity = {speed, 0, 0};
    scene.pairs.push_back({"steel", "steel", {}});
    Tether cord{.name = "cord", .item = 1, .point = {0, 0, 0.25}, .anchor = {0, 0, 0.25}};
    cord.slack_length = 1.1;
    cord.stiffness = stiffness;
    cord.anchor_item = 0;
    scene.tethers = {cord};
  }
  double reduced() const { return m1 * m2 / (m1 + m2); }
};

/// The cord of stiffness k turns their relative speed round in half a period pi sqrt(mu / k) of the reduced mass mu,
/// with the tension v sqrt(k mu), and momentum is kept. The method is late by (omega h)^2 of it, 3e-4 at 1 ms, and the
/// kink of the cord costs up to a step.
TEST(TetherBetweenItems, TurnsTheirRelativeSpeedRound) {
  const TwoBlocks two;
  const double mu = two.reduced(), omega = std::sqrt(two.stiffness / mu);
  const double h = 0.001;
  const Response r = simulate(two.scene, {}, blocks::run_for(0.5, h, 0.5));
  ASSERT_EQ(r.outcome, Outcome::kStopped) << r.cause;
  const double v1 = r.items[0].history.back().velocity.x(),
               v2 = r.items[1].history.back().velocity.x();
  EXPECT_NEAR(two.m1 * v1 + two.m2 * v2, two.m2 * two.speed, 1e-9);
  const double tolerance = std::pow(omega * h, 2) + omega * h * omega * h;
  EXPECT_NEAR(v2 - v1, -two.speed, tolerance);
  EXPECT_NEAR(r.tethers[0].peak_tension, two.speed * std::sqrt(two.stiffness * mu),
              tolerance * two.speed * std::sqrt(two.stiffness * mu));
  EXPECT_NEAR(r.tethers[0].time_taut, 0.1 / two.speed, 1.5 * h);
  EXPECT_LT(r.tethers[0].time_broken, 0);
  EXPECT_LT(r.quality.energy_closure, 1e-4);
}

/// At its strength F it has the energy F^2 / (2 k), which the relative motion has lost and does not get back.
TEST(TetherBetweenItems, BreaksAtItsStrength) {
  TwoBlocks two;
  const double strength = 100, mu = two.reduced();
  two.scene.tethers[0].strength = strength;
  const Response r = simulate(two.scene, {}, blocks::run_for(0.5, 0.001, 0.5));
  EXPECT_NEAR(r.tethers[0].peak_tension, strength, 1e-5);
  EXPECT_GT(r.tethers[0].time_broken, r.tethers[0].time_taut);
  const double left =
      r.items[1].history.back().velocity.x() - r.items[0].history.back().velocity.x();
  const double lost = strength * strength / (2 * two.stiffness);
  EXPECT_NEAR(mu * left * left / 2, mu * two.speed * two.speed / 2 - lost, 1e-3 * lost);
  EXPECT_LT(r.quality.energy_closure, 1e-4);
}

/// A slack cord that pulls with 2 N at both accelerates each towards the other.
TEST(TetherBetweenItems, PullsBothWhileSlack) {
  TwoBlocks two;
  two.scene.items[1].initial.velocity = Vector3::Zero();
  two.scene.tethers[0].slack_pull = 2;
  const Response r = simulate(two.scene, {}, blocks::run_for(1, 0.004, 1));
  EXPECT_NEAR(r.items[0].history.back().displacement.x(), 1 / two.m1, 1e-6);
  EXPECT_NEAR(r.items[1].history.back().displacement.x(), -1 / two.m2, 1e-6);
  EXPECT_LT(r.tethers.at(0).time_taut, 0);
  EXPECT_LT(r.quality.energy_closure, 1e-6);
}

/// Off their middles it turns them: with the momentum their moment of momentum about the floor's origin is kept, of
/// which each has m (x v_y - y v_x) + I w, w from the last two samples of its yaw.
TEST(TetherBetweenItems, KeepsTheMomentOfMomentum) {
  TwoBlocks two;
  two.scene.tethers[0].point = {0.1, 0.15, 0.25};
  two.scene.tethers[0].anchor = {0, -0.2, 0.25};
  two.scene.tethers[0].slack_length = 1.2;
  const double h = 0.001;
  const Response r = simulate(two.scene, {}, blocks::run_for(0.4, h, h));
  double moment = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& history = r.items[i].history;
    const Sample &now = history.back(), &before = history[history.size() - 3];
    const Vector3 place = two.scene.items[i].initial.position + now.displacement;
    const double mass = i == 0 ? two.m1 : two.m2, inertia = mass * 0.32 / 12;
    moment += mass * (place.x() * now.velocity.y() - place.y() * now.velocity.x()) +
              inertia * (now.yaw - before.yaw) / (now.time - before.time);
  }
  EXPECT_GT(r.tethers[0].peak_tension, 10);
  // It was 0: the second slid along the x axis. Rates of yaw by differences are those of a step ago.
  EXPECT_NEAR(moment, 0, 1e-4 * two.m2 * two.speed);
}

TEST(TetherBetweenItems, MustEndAtAnotherItem) {
  TwoBlocks two;
  two.scene.tethers[0].anchor_item = 1;
  EXPECT_ANY_THROW(simulate(two.scene, {}, blocks::run_for(0.1, 0.004, 0.1)));
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
/// law gets, a method of second order errs by (omega dt)^2 of the motion since the cord got taut,
/// and by the kink within one step; the reference by its own step. Breaking at the end of a step
/// would be late by half of one, 2 ms.
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
