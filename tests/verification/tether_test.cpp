#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/simulate.h"
#include "studies/verification/scenes/blocks.h"

// A block that slides without friction into the end of its cord.
namespace gurney {
namespace {

constexpr double kMass = 50, kSlack = 0.2, kSpeed = 0.6;

/// The cord runs along x through the block's centre: it pulls straight back.
Scene tied(double stiffness, double damping, double strength) {
  Scene scene = blocks::block(kMass, {0.4, 0.4, 0.5}, {.friction = 0});
  scene.items[0].initial.velocity = {kSpeed, 0, 0};
  Tether cord{.name = "cord", .point = {-0.2, 0, 0.25}, .anchor = {-1.2, 0, 0.25}};
  cord.slack_length = 1 + kSlack;
  cord.stiffness = stiffness;
  cord.damping = damping;
  cord.strength = strength;
  scene.tethers = {cord};
  return scene;
}

constexpr double kUnbreakable = std::numeric_limits<double>::infinity();

// While taut, x'' = -(k / m) x: taut for half a period, T = v sqrt(k m), and thrown back with all
// of its speed. The method is of second order with an error of (omega h)^2 / 12 of the amplitude.
TEST(Tether, AnElasticCordThrowsTheBlockBack) {
  for (double k : {500.0, 5000.0}) {
    const double h = 0.002, omega = std::sqrt(k / kMass);
    const Response response = simulate(tied(k, 0, kUnbreakable), {}, blocks::run_for(2, h, h));
    const TetherOutcome& cord = response.tethers.at(0);
    EXPECT_NEAR(cord.time_taut, kSlack / kSpeed, 2 * h);
    EXPECT_LT(cord.time_broken, 0);
    const double error = omega * h;
    EXPECT_NEAR(cord.peak_tension, kSpeed * std::sqrt(k * kMass),
                error * error * kSpeed * std::sqrt(k * kMass) + 1e-3);
    EXPECT_NEAR(response.items[0].history.back().velocity.x(), -kSpeed, error * error * kSpeed);
    EXPECT_LT(response.quality.energy_closure, 1e-3);
  }
}

TEST(Tether, ADampedCordLosesEnergyAndTheAccountKnowsIt) {
  const Response response =
      simulate(tied(2000, 100, kUnbreakable), {}, blocks::run_for(2, 0.002, 0.002));
  const EnergyAccount& energy = response.items[0].energy;
  const double v = response.items[0].history.back().velocity.x();
  EXPECT_LT(v, 0);
  EXPECT_GT(v, -kSpeed);
  EXPECT_NEAR(energy.damper_loss, 0.5 * kMass * (kSpeed * kSpeed - v * v),
              1e-3 * 0.5 * kMass * kSpeed * kSpeed);
}

// It breaks where k s = strength, with m v'^2 = m v^2 - strength^2 / k left. The step that ends
// beyond the strength breaks it: up to k v h more than the strength.
TEST(Tether, AWeakCordBreaksAtItsStrengthAndTheBlockGoesOn) {
  const double k = 5000, strength = 150, h = 0.001;
  const Response response = simulate(tied(k, 0, strength), {}, blocks::run_for(1, h, h));
  const TetherOutcome& cord = response.tethers.at(0);
  const double omega = std::sqrt(k / kMass);
  const double expected = kSlack / kSpeed + std::asin(strength / k * omega / kSpeed) / omega;
  EXPECT_NEAR(cord.time_broken, expected, 2 * h);
  EXPECT_GT(cord.peak_tension, strength);
  EXPECT_LT(cord.peak_tension, strength + k * kSpeed * h);
  const double left = std::sqrt(kSpeed * kSpeed - strength * strength / (k * kMass));
  const double late =
      std::sqrt(kSpeed * kSpeed - cord.peak_tension * cord.peak_tension / (k * kMass));
  EXPECT_NEAR(response.items[0].history.back().velocity.x(), 0.5 * (left + late),
              0.5 * (left - late) + 1e-4);
  EXPECT_LT(response.quality.energy_closure, 1e-3);
}

TEST(Tether, MustReachItsAnchor) {
  Scene scene = tied(500, 0, kUnbreakable);
  scene.tethers[0].slack_length = 0.9;
  EXPECT_ANY_THROW(simulate(scene, {}, blocks::run_for(1, 0.004, 0.1)));
}

}  // namespace
}  // namespace gurney
