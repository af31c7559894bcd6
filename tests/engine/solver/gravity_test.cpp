#include <gtest/gtest.h>

#include <cmath>

#include "engine/solver/mechanism.h"

namespace gurney {
namespace {

/// Slopes of 0.03 and 0.04 are one of 0.05 along (3, 4) / 5: the angle is atan(0.05).
TEST(Gravity, PullsDownTheSteepestSlope) {
  const double angle = std::atan(0.05), rounding = 1e-15 * 9.8;
  const Vector3 g = gravity_on_slope(9.8, 0.03, 0.04);
  EXPECT_NEAR(g.x(), -9.8 * std::sin(angle) * 0.6, rounding);
  EXPECT_NEAR(g.y(), -9.8 * std::sin(angle) * 0.8, rounding);
  EXPECT_NEAR(g.z(), -9.8 * std::cos(angle), rounding);
}

TEST(Gravity, IsPlainOnALevelFloorAndAlongX) {
  EXPECT_EQ(gravity_on_slope(9.8, 0, 0), Vector3(0, 0, -9.8));
  const double angle = std::atan(-0.1);
  EXPECT_EQ(gravity_on_slope(9.8, -0.1, 0),
            Vector3(-9.8 * std::sin(angle), 0, -9.8 * std::cos(angle)));
}

}  // namespace
}  // namespace gurney
