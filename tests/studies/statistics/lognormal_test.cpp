#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "studies/statistics/special.h"
#include "tests/support/expect_error.h"

namespace gurney::statistics {
namespace {

TEST(Lognormal, IsANormalDistributionOfTheLogarithm) {
  const LognormalCurve curve{0.5, 0.4};
  EXPECT_DOUBLE_EQ(curve.probability(0.5), 0.5);
  // Phi(1) of any table of the normal distribution
  EXPECT_NEAR(curve.probability(0.5 * std::exp(0.4)), 0.841344746068543, 1e-14);
  EXPECT_EQ(curve.probability(0), 0);
  EXPECT_EQ(curve.probability(-1), 0);
  EXPECT_NEAR(curve.quantile(0.841344746068543), 0.5 * std::exp(0.4), 1e-13);
}

TEST(Lognormal, HasMeanAndStandardDeviation) {
  // theta = 1, beta^2 = ln 2: mean sqrt 2, variance 2 (2 - 1)
  const LognormalCurve curve{1, std::sqrt(std::log(2.0))};
  EXPECT_NEAR(curve.mean(), std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(curve.standard_deviation(), std::sqrt(2.0), 1e-15);
}

TEST(Special, LogOfTheNormalDistributionReachesFarBelow) {
  EXPECT_NEAR(log_normal_cdf(0), -std::log(2.0), 1e-15);
  EXPECT_NEAR(log_normal_cdf(9), -1.12858840595384065e-19, 1e-32);
  // ln Phi(-x) lies between the bounds -x^2/2 - ln(x sqrt(2 pi)) + ln(1 - 1/x^2) and without the
  // last term (Gordon 1941).
  for (const double x : {36.9, 37.1, 100.0, 1e6}) {
    const double upper = -x * x / 2 - std::log(x) - std::log(2 * M_PI) / 2;
    EXPECT_LE(log_normal_cdf(-x), upper) << x;
    EXPECT_GE(log_normal_cdf(-x), upper + std::log1p(-1 / (x * x)) - 1e-15 * x * x) << x;
  }
  EXPECT_NEAR(log_normal_cdf(-37.0000001), log_normal_cdf(-36.9999999) - 2e-7 * 37.027, 1e-6);
  EXPECT_NEAR(normal_hazard_below(-100), 100 + 1 / 100.0, 1e-5);
}

// Chi-squared with two degrees is exponential, Student's with two t = (2p - 1) / sqrt(2p (1 - p)),
// F with two above (1 + 2 f / d)^(-d / 2); the rest from Abramowitz & Stegun 1964,
// tables 26.8, 26.10.
TEST(Special, AgreesWithClosedFormsAndTables) {
  EXPECT_NEAR(chi_squared_survival(3, 2), std::exp(-1.5), 1e-14);
  EXPECT_EQ(chi_squared_survival(-1, 2), 1);
  EXPECT_NEAR(chi_squared_quantile(0.95, 1), 3.84146, 1e-5);
  EXPECT_NEAR(student_quantile(0.975, 2), 0.95 / std::sqrt(2 * 0.975 * 0.025), 1e-12);
  EXPECT_NEAR(student_survival(0.95 / std::sqrt(2 * 0.975 * 0.025), 2), 0.025, 1e-14);
  EXPECT_NEAR(student_quantile(0.975, 9), 2.262, 1e-3);
  EXPECT_NEAR(fisher_survival(4, 2, 10), std::pow(1.8, -5), 1e-14);
  EXPECT_EQ(fisher_survival(0, 2, 10), 1);
  EXPECT_NEAR(binomial_cdf(1, 3, 0.5), 0.5, 1e-15);
  EXPECT_EQ(binomial_cdf(-1, 3, 0.5), 0);
}

}  // namespace
}  // namespace gurney::statistics
