#include "engine/solver/force_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gurney {
namespace {

TEST(ForceTable, IsLinearBetweenItsPointsAndZeroOutside) {
  const ForceTable table({1, 2, 4}, {0, 40, 10});
  EXPECT_EQ(table.value(0.999), 0);
  EXPECT_EQ(table.value(1), 0);
  EXPECT_EQ(table.value(1.5), 20);
  EXPECT_EQ(table.value(2), 40);
  EXPECT_EQ(table.value(3), 25);
  EXPECT_EQ(table.value(4), 10);
  EXPECT_EQ(table.value(4.001), 0);
}

TEST(ForceTable, ItsIntegralIsThatOfTrapezoids) {
  const ForceTable table({1, 2, 4}, {0, 40, 10});
  EXPECT_EQ(table.integral(0.5), 0);
  EXPECT_EQ(table.integral(1.5), 5);
  EXPECT_EQ(table.integral(2), 20);
  EXPECT_EQ(table.integral(3), 52.5);
  EXPECT_EQ(table.integral(4), 70);
  EXPECT_EQ(table.integral(9), 70);
}

TEST(ForceTable, WithoutAnIntervalItIsZero) {
  EXPECT_EQ(ForceTable({}, {}).value(0), 0);
  EXPECT_EQ(ForceTable({}, {}).integral(1), 0);
  EXPECT_EQ(ForceTable({1}, {5}).value(1), 0);
  EXPECT_EQ(ForceTable({1}, {5}).integral(2), 0);
}

// Of a half sine in 1000 lines: each line has 2 / pi less a share of w^2 h^2 / 12, w h = pi / 1000.
TEST(ForceTable, ManyPointsApproachTheCurveTheyAreTakenFrom) {
  std::vector<double> time, force;
  for (int i = 0; i <= 1000; ++i) {
    time.push_back(i / 1000.0);
    force.push_back(std::sin(M_PI * i / 1000.0));
  }
  const double rounding = 1e-12, share = std::pow(M_PI / 1000, 2) / 12;
  EXPECT_NEAR(ForceTable(time, force).integral(1), 2 / M_PI, 2 / M_PI * share * 1.01 + rounding);
}

}  // namespace
}  // namespace gurney
