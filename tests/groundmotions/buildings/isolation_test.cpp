#include "groundmotions/buildings/isolation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;

/// z' = way' inside the disc; on its edge without the part that leads out. Tiny steps, each put
/// back on the edge: an error of first order in their length.
Sliding in_tiny_steps(Vector2 z, const Vector2& way) {
  constexpr int kSteps = 200000;
  Vector2 sum = Vector2::Zero();
  for (int i = 0; i < kSteps; ++i) {
    const Vector2 before = z;
    z += way / kSteps;
    if (z.norm() > 1) z.normalize();
    sum += (before + z) / 2;
  }
  return {z, sum / kSteps};
}

// The tiny steps' error is of the order of their length, at most 5 / 200000 here.
TEST(Isolation, SlidingIsTheLimitOfTinySteps) {
  const Vector2 starts[] = {{0, 0}, {0.3, -0.8}, {0.6, 0.8}, {-1, 0}, {0, 1}};
  const Vector2 ways[] = {{0.1, 0.05}, {1.5, 0}, {-3, 2}, {0.5, -4.9}};
  for (const Vector2& z : starts)
    for (const Vector2& way : ways) {
      const Sliding exact = slide(z, way), tiny = in_tiny_steps(z, way);
      EXPECT_LT((exact.end - tiny.end).norm(), 3e-5) << z.transpose() << " by " << way.transpose();
      EXPECT_LT((exact.mean - tiny.mean).norm(), 3e-5);
      EXPECT_LE(exact.end.norm(), 1 + 1e-15);
    }
}

TEST(Isolation, TwoWaysInLineAreOne) {
  const Vector2 z(-0.2, 0.5), way(2, -1);
  const Sliding first = slide(z, 0.3 * way), second = slide(first.end, 0.7 * way);
  const Sliding whole = slide(z, way);
  EXPECT_LT((second.end - whole.end).norm(), 1e-14);
  EXPECT_LT((0.3 * first.mean + 0.7 * second.mean - whole.mean).norm(), 1e-14);
}

TEST(Isolation, SlidingTurnsWithTheAxes) {
  const Eigen::Rotation2Dd turn(0.7);
  const Sliding straight = slide(Vector2(0.4, 0.6), Vector2(-2, 1));
  const Sliding turned = slide(turn * Vector2(0.4, 0.6), turn * Vector2(-2, 1));
  EXPECT_LT((turned.end - turn * straight.end).norm(), 1e-15);
  EXPECT_LT((turned.mean - turn * straight.mean).norm(), 1e-15);
}

// Along a line through the middle: elastic by 1.5, then at the edge; mean of -0.5..1 over 1.5 and
// of 1 over 0.5.
TEST(Isolation, OneDirectionIsElasticPerfectlyPlastic) {
  const Sliding line = slide(Vector2(-0.5, 0), Vector2(2, 0));
  EXPECT_EQ(line.end, Vector2(1, 0));
  EXPECT_NEAR(line.mean.x(), (1.5 * 0.25 + 0.5) / 2, 1e-15);
  EXPECT_EQ(line.mean.y(), 0);
}

TEST(Isolation, LeadRubberIsBilinear) {
  const Isolation bearing = lead_rubber(2.5, 0.06, 0.01, 0.02);
  EXPECT_NEAR(bearing.stiffness, std::pow(2 * pi / 2.5, 2), 1e-13);
  EXPECT_NEAR(bearing.viscosity, 2 * 0.02 * 2 * pi / 2.5, 1e-14);
  EXPECT_EQ(bearing.strength(0), 0.06 * kStandardGravity);
  EXPECT_EQ(bearing.strength(1), 0.06 * kStandardGravity);
  EXPECT_EQ(bearing.yield_displacement, 0.01);
  EXPECT_FALSE(bearing.follows_vertical);
}

TEST(Isolation, FrictionRisesWithVelocity) {
  const Isolation pendulum = friction_pendulum(2, 0.03, 0.06, 50, 5e-4);
  EXPECT_NEAR(pendulum.stiffness, kStandardGravity / 2, 1e-15);
  EXPECT_NEAR(pendulum.strength(0) / kStandardGravity, 0.03, 1e-15);
  EXPECT_NEAR(pendulum.strength(0.02) / kStandardGravity, 0.06 - 0.03 * std::exp(-1.0), 1e-15);
  EXPECT_NEAR(pendulum.strength(10) / kStandardGravity, 0.06, 1e-15);
  EXPECT_TRUE(pendulum.follows_vertical);
}

}  // namespace
}  // namespace gurney::groundmotions
