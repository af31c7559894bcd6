#include "studies/calibration/trials/polynomial_fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gurney::calibration {
namespace {

// Deviations e (1, -1, -1, 1) of a line through t = 1, 2, 3, 4 are orthogonal to 1 and t: the line stays, with n - 2 = 2
// degrees of freedom s^2 = 4 e^2 / 2, and var c_0 = s^2 / 4, var c_1 = s^2 / sum (t - 2.5)^2 = s^2 / 5.
TEST(PolynomialFit, OfALineHasItsStandardErrors) {
  const double e = 0.1, s = std::sqrt(2) * e;
  const std::vector<double> time = {0, 1, 2, 3, 4, 5};
  std::vector<double> y = {9, 0, 0, 0, 0, 9};
  for (std::size_t i = 1; i < 5; ++i) y[i] = 3 + 2 * (time[i] - 2.5) + (i == 1 || i == 4 ? e : -e);
  const PolynomialFit fit = fit_polynomial(time, y, {1, 5}, 1);
  EXPECT_EQ(fit.middle, 2.5);
  EXPECT_NEAR(fit.c[0], 3, 1e-14);
  EXPECT_NEAR(fit.c[1], 2, 1e-14);
  EXPECT_NEAR(fit.value(4), 6, 1e-14);
  EXPECT_NEAR(fit.residual, s, 1e-14);
  EXPECT_NEAR(fit.covariance(0, 0), s * s / 4, 1e-14);
  EXPECT_NEAR(fit.rate_error(0), s / std::sqrt(5), 1e-14);
}

// s = sqrt(e' e / (n - 3)), and the second derivative of a quadratic over t = -2 to 2 has the variance
// 4 s^2 / sum (t^2 - 2)^2 = 4 s^2 / 14.
TEST(PolynomialFit, OfAQuadraticHasItsAcceleration) {
  const std::vector<double> time = {0, 0.5, 1, 1.5, 2};
  const double shape[] = {1, -4, 6, -4, 1};  // orthogonal to 1, t, t^2, t^3; sum of squares 70
  std::vector<double> y;
  for (std::size_t i = 0; i < 5; ++i)
    y.push_back(1.5 * std::pow(time[i] - 1, 2) - (time[i] - 1) + 0.01 * shape[i]);
  const PolynomialFit fit = fit_polynomial(time, y, {0, 5}, 2);
  const double s = 0.01 * std::sqrt(70.0 / 2);
  EXPECT_NEAR(fit.acceleration(), 3, 1e-13);
  EXPECT_NEAR(fit.rate(2), 2, 1e-13);
  EXPECT_NEAR(fit.residual, s, 1e-13);
  EXPECT_NEAR(fit.acceleration_error(), 2 * s / std::sqrt(14) / 0.25,
              1e-12);  // t in halves of a second
}

}  // namespace
}  // namespace gurney::calibration
