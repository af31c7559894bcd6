#include "studies/statistics/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// (d / 2)^2 reaches 3 at 2 sqrt(3) on either side, whatever the step; to 1e-9 of a bracket of at most twice that.
TEST(Crossing, IsWhereADropRisesThroughItsLimit) {
  const auto parabola = [](double d) { return d * d / 4; };
  for (const double step : {0.1, 1.0, 10.0, -0.1, -1.0, -10.0})
    EXPECT_NEAR(crossing(parabola, 3, step), std::copysign(2 * std::sqrt(3.0), step), 1e-7) << step;
}

// A wall of infinite likelihood, a drop with a jump, and one that is no number before it rises.
TEST(Crossing, TakesDropsThatAreNotSmooth) {
  EXPECT_NEAR(crossing([](double d) { return d < 0.7 ? 0 : kInfinity; }, 3, 0.5), 0.7, 1e-8);
  EXPECT_NEAR(crossing([](double d) { return d < -0.7 ? 5.0 : 1.0; }, 3, -0.5), -0.7, 1e-8);
  EXPECT_NEAR(crossing([](double d) { return d < 2 ? std::nan("") : d * d; }, 9, 1), 3, 1e-8);
}

TEST(Crossing, IsInfiniteWhereADropStaysLow) {
  EXPECT_EQ(crossing([](double) { return 1.0; }, 3, 0.1), kInfinity);
  EXPECT_EQ(crossing([](double) { return 1.0; }, 3, -0.1), -kInfinity);
  EXPECT_EQ(crossing([](double d) { return d * d; }, 3, 0), kInfinity) << "no step";
}

}  // namespace
}  // namespace gurney::statistics
