#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/blocks.h"

// Items without casters: a rigid block on the floor that stands, slides and rocks.
namespace gurney {
namespace {

using std::numbers::pi;
constexpr double kG = kStandardGravity;

ContactConstants floor_of(double friction, double stiffness = 1e8) {
  return {.stiffness = stiffness, .restitution = 0.05, .friction = friction};
}

Response shake(const Scene& scene, const FloorMotion& floor, const SimulationSettings& settings) {
  Excitation excitation;
  excitation.floor = floor;
  return simulate(scene, excitation, settings);
}

TEST(Block, StandsStillBelowFriction) {
  const Scene scene = blocks::block(120, {0.6, 0.5, 0.8}, floor_of(0.4, 1e7));
  const auto floor = scenes::rectangular_pulse(0.3 * kG, 2);
  const Response response = shake(scene, floor, blocks::run_for(3, 0.004, 0.1));
  ASSERT_EQ(response.outcome, Outcome::kStopped) << response.cause;
  // Stuck corners deflect by m a / (4 k_t) = 11 um, and by twice that when loaded at once; the
  // centre, 0.4 m up, tilts with the normal springs by about as much. Nothing creeps.
  EXPECT_LT(response.items[0].demands.peak_displacement, 1e-4);
  const auto at = [&](double t) {
    return response.items[0]
        .history[static_cast<std::size_t>(std::lround(t / 0.1))]
        .displacement.x();
  };
  EXPECT_NEAR(at(1.9), at(1.0), 1e-7) << "creeps";
  // Corners that carry little slip until the others hold: less than they deflect.
  EXPECT_LT(response.items[0].demands.residual_displacement, 2.2e-5);
  EXPECT_EQ(response.items[0].demands.impacts, 0) << "resting contact is no impact";
}

TEST(Block, SlidesUnderAPulseAsCoulombSays) {
  // Floor acceleration a for T, friction mu g: relative to the floor the block gains
  // (a - mu g) T, then stops at mu g: s = (a - mu g) T^2 / 2 * (a / (mu g)).
  for (double mu : {0.2, 0.35})
    for (double a : {0.5, 0.8}) {
      const double T = 0.3, acceleration = a * kG;
      const Scene scene = blocks::block(120, {0.9, 0.9, 0.3}, floor_of(mu));
      const Response response =
          shake(scene, scenes::rectangular_pulse(acceleration, T), blocks::run_for(2, 0.002, 0.1));
      const double s = (acceleration - mu * kG) * T * T / 2 * acceleration / (mu * kG);
      // The stuck corners give back their deflection, (mu m g) / (4 k_t) = 2 um at k 1e8; the pulse
      // begins in one step of 2 ms at half its height: a h^2 / 2 over s, below 0.3 %.
      EXPECT_NEAR(response.items[0].demands.residual_displacement, s, 0.003 * s) << mu << ", " << a;
      EXPECT_EQ(response.items[0].demands.impacts, 0);
    }
}

TEST(Block, UpliftBeginsAtWidthOverHeight) {
  // A slender block begins to rock when a / g exceeds b / h (West's formula, Milne 1885).
  for (double width : {0.2, 0.3}) {
    const Vector3 size(width, 0.6, 1.2);
    const double threshold = size.x() / size.z() * kG;
    const auto tilt = [&](double a) {
      const Scene scene = blocks::block(150, size, floor_of(1.5));
      // A slow rise holds no shock; 1 s up to a, and held.
      const FloorMotion floor = scenes::floor_motion(0.01, 1.2, Vector3::UnitX(), [=](double t) {
        return a * std::min(1.0, 0.5 * (1 - std::cos(pi * std::min(t, 1.0))));
      });
      SimulationSettings settings = blocks::run_for(1.2, 0.004, 0.1);
      settings.follow_overturning = false;
      return shake(scene, floor, settings).items[0].demands.peak_tilt;
    };
    // Below, the corners' springs tilt it by 2 W / (k b) at most: 1e-4 rad.
    EXPECT_LT(tilt(0.98 * threshold), 2e-4) << width;
    EXPECT_GT(tilt(1.05 * threshold), 1e-3) << width;
  }
}

}  // namespace
}  // namespace gurney
