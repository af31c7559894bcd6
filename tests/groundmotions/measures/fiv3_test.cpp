#include "groundmotions/measures/fiv3.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using Eigen::VectorXd;
constexpr double kPi = std::numbers::pi;

// A sine of period P that swells and fades slowly: both passes of the filter leave the factor
// 1 / (1 + (P_c / P)^4) of it, P_c = T / beta, and a window of w s holds A P / pi |sin(pi w / P)|
// at most, so FIV3 is three times that. The bilinear transform bends all frequencies but the
// corner's, so P = P_c is taken, where the factor is 1/2. Straight lines lose (2 pi / 500)^2 / 12
// = 1.3e-5, maxima at samples (2 pi / 1000)^2 / 2 = 2.0e-5.
TEST(Fiv3, OfASineAtTheCorner) {
  const double period = 0.85, sine_period = 1.0, dt = 0.002;
  VectorXd a(60001);
  for (int i = 0; i < a.size(); ++i) {
    const double t = i * dt;
    const double envelope = 1 / (1 + std::exp((15 - t) / 2)) / (1 + std::exp((t - 105) / 2));
    a[i] = 4 * envelope * std::sin(2 * kPi * t / sine_period);
  }
  const double exact = 3 * 0.5 * 4 * sine_period / kPi * std::sin(kPi * 0.7 * period / sine_period);
  EXPECT_NEAR(fiv3(dt, a, period), exact, 4e-5 * exact);
}

void add_pulse(VectorXd& a, int start, double height) {
  for (int i = 0; i <= 100; ++i) a[start + i] += height * std::pow(std::sin(kPi * i / 100), 2);
}

// Pulses of 0.5 s that are 9 s apart, five of one sign and one of the other, against three pulses
// of height 1.
TEST(Fiv3, SumsTheThreeLargestOfOneSign) {
  const double dt = 0.005, period = 0.5;
  VectorXd a = VectorXd::Zero(12001), ones = a;
  for (const int start : {1000, 3000, 5000}) add_pulse(ones, start, 1);
  const double heights[] = {1, 4, 2, 5, 3, -7};
  for (int k = 0; k < 6; ++k) add_pulse(a, 1000 + 1800 * k, heights[k]);
  const double expected = (4 + 5 + 3) * fiv3(dt, ones, period) / 3;
  EXPECT_GT(expected, 2);  // the window of 0.35 s holds most of the area of 0.25 m/s
  // The filter's answer to other pulses has died out as exp(-2 pi 1.7 8.5 / sqrt(2)) = 1e-28.
  EXPECT_NEAR(fiv3(dt, a, period), expected, 1e-12);
  EXPECT_NEAR(fiv3(dt, -3 * a, period), 3 * expected, 1e-12);
}

TEST(Fiv3, OfNothingIsZero) { EXPECT_EQ(fiv3(0.01, VectorXd::Zero(500), 1), 0); }

TEST(Fiv3, RefusesPeriodsItHasNoValueFor) {
  const VectorXd a = VectorXd::Ones(1001);
  EXPECT_EQ(error_text([&] { fiv3(0.01, a, 0.01); }),
            "FIV3(0.01): the period must be above 0.017 s, as the filter's corner must lie below "
            "half the sampling rate");
  EXPECT_EQ(error_text([&] { fiv3(0.01, a, 20); }),
            "FIV3(20): the period must be at most 14.2857 s, as a window of 0.7 times the period "
            "must fit into the record of 10 s");
}

}  // namespace
}  // namespace gurney::groundmotions
