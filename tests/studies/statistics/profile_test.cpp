#include "studies/statistics/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// d^2 (1 + d / 20) / 4, whose root is not straight, reaches 3 where it does by its own formula: the place is known
// to 1e-9 of a bracket of at most 10, and the slope there is below 3.
TEST(Crossing, IsWhereADropRisesThroughItsLimit) {
  const auto curved = [](double d) { return d * d * (1 + d / 20) / 4; };
  for (const double step : {0.1, 1.0, 10.0, -0.1, -1.0, -10.0}) {
    const double at = crossing(curved, 3, step);
    EXPECT_NEAR(curved(at), 3, 3e-8) << step;
    EXPECT_GT(at * step, 0) << step;
  }
}

// Drops without bound, with a jump, and that are no number before they rise.
TEST(Crossing, TakesDropsThatAreNotSmooth) {
  EXPECT_NEAR(crossing([](double d) { return d < 0.7 ? 0 : kInfinity; }, 3, 0.5), 0.7, 1e-8);
  EXPECT_NEAR(crossing([](double d) { return d < -0.7 ? 5.0 : 1.0; }, 3, -0.5), -0.7, 1e-8);
  EXPECT_NEAR(crossing([](double d) { return d < 2.5 ? std::nan("") : d * d; }, 9, 1), 3, 1e-8);
}

TEST(Crossing, IsInfiniteWhereADropStaysLow) {
  EXPECT_EQ(crossing([](double) { return 1.0; }, 3, 0.1), kInfinity);
  EXPECT_EQ(crossing([](double) { return 1.0; }, 3, -0.1), -kInfinity);
  EXPECT_EQ(crossing([](double d) { return d * d; }, 3, 0), kInfinity) << "no step";
}

}  // namespace
}  // namespace gurney::statistics
