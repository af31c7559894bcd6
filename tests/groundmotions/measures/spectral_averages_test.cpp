#include <gtest/gtest.h>

#include <cmath>

#include "groundmotions/measures/measure.h"
#include "groundmotions/measures/response_spectrum.h"

namespace gurney::groundmotions {
namespace {

using Eigen::VectorXd;

TEST(AveragePeriods, AreAHundredthOfASecondApart) {
  const VectorXd t = average_periods(1);
  EXPECT_EQ(t.size(), 281);
  EXPECT_DOUBLE_EQ(t[0], 0.2);
  EXPECT_DOUBLE_EQ(t[1], 0.21);
  EXPECT_DOUBLE_EQ(t[280], 3);
}

TEST(AveragePeriods, AreAtLeastTen) {
  const VectorXd t = average_periods(0.01);
  EXPECT_EQ(t.size(), 10);
  EXPECT_DOUBLE_EQ(t[9], 0.03);
}

TEST(GeometricMean, OfAFlatSpectrumIsItsLevel) {
  EXPECT_DOUBLE_EQ(geometric_mean(VectorXd::Constant(50, 3.7)), 3.7);
}

TEST(GeometricMean, OfTwoNumbersAndOfZero) {
  EXPECT_DOUBLE_EQ(geometric_mean(Eigen::Vector2d(2, 8)), 4);
  EXPECT_EQ(geometric_mean(Eigen::Vector2d(0, 8)), 0);
}

// A jump of velocity V: a triangle of acceleration of 2 ms. PSV at zero damping would be V for
// every period; with 5 % the first peak is V exp(-z / sqrt(1 - z^2) atan(sqrt(1 - z^2) / z)). The
// integral over 2.4 s is exact for a constant. Triangle against jump: (pi 1 ms / T)^2 / 6 < 2e-4.
TEST(SpectrumIntensity, OfAJumpOfVelocity) {
  const double dt = 0.001, z = 0.05, root = std::sqrt(1 - z * z), jump = 0.3;
  VectorXd a = VectorXd::Zero(4000);
  a[1] = jump / dt;
  const double psv = jump * std::exp(-z / root * std::atan(root / z));
  EXPECT_NEAR(spectrum_intensity(dt, a), 2.4 * psv, 4e-4 * 2.4 * psv);
}

}  // namespace
}  // namespace gurney::groundmotions
