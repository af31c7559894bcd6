#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "groundmotions/measures/measure.h"

namespace gurney::groundmotions {
namespace {

using Eigen::VectorXd;
constexpr double kPi = std::numbers::pi;

/// A sine under an envelope that ends at zero, 40 s long.
VectorXd burst(double frequency, double dt) {
  VectorXd a(static_cast<int>(40 / dt) + 1);
  for (int i = 0; i < a.size(); ++i)
    a[i] = std::sin(2 * kPi * frequency * i * dt) * std::pow(std::sin(kPi * i * dt / 40), 2);
  return a;
}

// The spectrum of the burst is a line less than 0.1 Hz wide: 1 / f averages to 1 / f (1 + s^2 /
// f^2) with a standard deviation s of the squared line of 1 / (2 pi) sqrt(mean e'^2 / mean e^2) =
// sqrt(1/3) / 40 Hz: s^2 / f^2 = 5e-5 at 2 Hz.
TEST(MeanPeriod, OfASineIsItsPeriod) {
  EXPECT_NEAR(mean_period(0.01, burst(2, 0.01)), 0.5, 0.5 * 6e-5);
  EXPECT_NEAR(mean_period(0.005, burst(2, 0.005)), 0.5, 0.5 * 6e-5);
}

// Two lines far apart with amplitudes 1 and 2: (1 / f1 + 4 / f2) / 5.
TEST(MeanPeriod, WeighsByTheSquaredAmplitude) {
  const VectorXd a = burst(1, 0.01) + 2 * burst(5, 0.01);
  const double exact = (1.0 + 4 / 5.0) / 5;
  EXPECT_NEAR(mean_period(0.01, a), exact, 2.1e-4 * exact);  // s^2 / f^2 at 1 Hz
}

// Side lobes of the burst at 0.1 Hz are below 1e-3 of it in the band: (5e-3)^2 at weights of up to
// 4 s against 0.5 s is 2e-4.
TEST(MeanPeriod, LeavesOutWhatIsOutsideTheBand) {
  const VectorXd a = burst(2, 0.01) + 5 * burst(0.1, 0.01) + 5 * burst(35, 0.01);
  EXPECT_NEAR(mean_period(0.01, a), 0.5, 1e-4);
}

TEST(MeanPeriod, OfNothingIsZero) { EXPECT_EQ(mean_period(0.01, VectorXd::Zero(100)), 0); }

// A long sine resonates most at its own period, up to the 1.6 % between periods.
TEST(PredominantPeriod, OfASineIsItsPeriod) {
  EXPECT_NEAR(predominant_period(0.01, burst(2, 0.01)), 0.5, 0.008);
  EXPECT_EQ(predominant_period(0.01, VectorXd::Zero(100)), 0);
}

}  // namespace
}  // namespace gurney::groundmotions
