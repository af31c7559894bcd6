#include "groundmotions/measures/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "groundmotions/measures/response_spectrum.h"

namespace gurney::groundmotions {
namespace {

using Eigen::VectorXd;

VectorXd motion(double rate, int samples) {
  VectorXd a(samples);
  for (int i = 0; i < samples; ++i) a[i] = std::sin(rate * i) + std::cos(0.37 * rate * i * i);
  return a;
}

// |cos theta| over 0, 1, ..., 179 degrees: smallest 0 at 90, largest 1 at 0; ordered, the values
// are 0, sin 1, sin 1, sin 2, sin 2, ...: numbers 89 and 90 (from 0) are both sin 45.
TEST(Rotation, OfMotionInOneDirection) {
  const VectorXd x = motion(0.2, 300), y = VectorXd::Zero(300);
  const double peak = x.cwiseAbs().maxCoeff();
  const RotatedValues values = rotated_peaks(x, y);
  EXPECT_NEAR(percentile(values, 0), 0, 1e-15);
  EXPECT_NEAR(percentile(values, 50), peak * std::sqrt(0.5), 1e-14);
  EXPECT_EQ(percentile(values, 100), peak);
}

TEST(Rotation, OfACircleIsTheSameForAllAngles) {
  VectorXd x(361), y(361);
  for (int i = 0; i < 361; ++i) {
    x[i] = 3 * std::cos(i * kRadiansPerDegree);
    y[i] = 3 * std::sin(i * kRadiansPerDegree);
  }
  const RotatedValues values = rotated_peaks(x, y);
  EXPECT_NEAR(percentile(values, 0), 3, 1e-14);
  EXPECT_NEAR(percentile(values, 100), 3, 1e-14);
}

// The shortcut leaves out points; the plain way does not.
TEST(Rotation, IsThatOfEveryPoint) {
  for (const double stretch : {1.0, 0.1, 1e-3}) {
    const VectorXd x = motion(0.2, 2000), y = stretch * motion(0.31, 2000) + 0.3 * x;
    const RotatedValues values = rotated_peaks(x, y);
    for (int i = 0; i < kRotationAngles; ++i) {
      const double c = std::cos(i * kRadiansPerDegree), s = std::sin(i * kRadiansPerDegree);
      EXPECT_NEAR(values[i], (c * x + s * y).cwiseAbs().maxCoeff(), 1e-14);
    }
  }
}

TEST(Percentile, IsLinearBetweenOrderedValues) {
  RotatedValues values;
  for (int i = 0; i < kRotationAngles; ++i) values[i] = 179 - i;
  EXPECT_EQ(percentile(values, 0), 0);
  EXPECT_EQ(percentile(values, 50), 89.5);
  EXPECT_EQ(percentile(values, 100), 179);
}

// The oscillator is linear: the spectrum of the turned motion is the turned response.
TEST(RotatedSpectrum, IsThatOfTurnedMotions) {
  const double dt = 0.01;
  const VectorXd h1 = motion(0.2, 800), h2 = 0.7 * motion(0.31, 800);
  VectorXd periods(11);
  periods << 0, logarithmic_periods(0.05, 4, 10);
  const RotatedSpectrum s = rotated_spectrum(dt, h1, h2, periods);
  Eigen::MatrixXd turned(11, kRotationAngles);
  for (int i = 0; i < kRotationAngles; ++i) {
    const double cosine = std::cos(i * kRadiansPerDegree), sine = std::sin(i * kRadiansPerDegree);
    turned.col(i) = response_spectrum(dt, cosine * h1 + sine * h2, periods).pseudo_acceleration;
  }
  for (int k = 0; k < periods.size(); ++k) {
    VectorXd row = turned.row(k);
    std::sort(row.begin(), row.end());
    EXPECT_NEAR(s.rotd00[k], row[0], 1e-12 * row[179]);
    EXPECT_NEAR(s.rotd50[k], (row[89] + row[90]) / 2, 1e-12 * row[179]);
    EXPECT_NEAR(s.rotd100[k], row[179], 1e-12 * row[179]);
  }
}

}  // namespace
}  // namespace gurney::groundmotions
