#include "engine/base/random/normal_draw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace gurney {
namespace {

// The inverse of Phi(x) = erfc(-x / sqrt 2) / 2. In the lower tail phi(x) is about |x| Phi(x), so a
// relative error e of x is one of x^2 e in Phi; five roundings (log, root, two sums, quotient), and
// erfc's own few.
TEST(NormalQuantile, InvertsTheDistributionFunction) {
  constexpr double kRounding = std::numeric_limits<double>::epsilon() / 2;
  for (const double p : {1e-300, 1e-100, 1e-20, 1e-10, 1e-6, 0.01, 0.074, 0.076, 0.3, 0.6, 0.95}) {
    const double x = normal_quantile(p);
    EXPECT_NEAR(std::erfc(-x / std::numbers::sqrt2) / 2 / p, 1, (5 * x * x + 6) * kRounding) << p;
  }
  EXPECT_EQ(normal_quantile(0.5), 0);
  EXPECT_DOUBLE_EQ(normal_quantile(0.975), -normal_quantile(0.025));
}

// Means of n draws scatter by 1 / sqrt n, their variance by sqrt(2 / n): 4 standard deviations.
TEST(NormalDraw, HasTheMomentsOfTheNormalDistribution) {
  const int n = 100000;
  double sum = 0, squares = 0, lag = 0, cross = 0, previous = 0;
  for (int i = 0; i < n; ++i) {
    const double x = normal_draw(7, 0, static_cast<std::uint64_t>(i));
    sum += x;
    squares += x * x;
    lag += x * previous;
    cross += x * normal_draw(7, 1, static_cast<std::uint64_t>(i));
    previous = x;
  }
  const double scatter = 4 / std::sqrt(n);
  EXPECT_NEAR(sum / n, 0, scatter);
  EXPECT_NEAR(squares / n, 1, std::sqrt(2) * scatter);
  EXPECT_NEAR(lag / n, 0, scatter);
  EXPECT_NEAR(cross / n, 0, scatter);
}

TEST(NormalDraw, DependsOnSeedStreamAndIndexOnly) {
  EXPECT_EQ(normal_draw(1, 2, 3), normal_draw(1, 2, 3));
  EXPECT_NE(normal_draw(1, 2, 3), normal_draw(2, 2, 3));
  EXPECT_NE(normal_draw(1, 2, 3), normal_draw(1, 3, 3));
  EXPECT_NE(normal_draw(1, 2, 3), normal_draw(1, 2, 4));
}

}  // namespace
}  // namespace gurney
