#include "groundmotions/measures/cumulative.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/units.h"

namespace gurney::groundmotions {
namespace {

using Eigen::VectorXd;
constexpr double kPi = std::numbers::pi;

/// 5 cycles of a sine of amplitude 2 m/s2 in 10 s, samples 1/500 of a cycle apart.
struct Sine {
  static constexpr double kStep = 0.004, kAmplitude = 2;
  VectorXd a{2501};
  Sine() {
    for (int i = 0; i < a.size(); ++i) a[i] = kAmplitude * std::sin(kPi * i * kStep);
  }
};

// int a^2 = A^2 D / 2. The trapezoid of a periodic function over whole cycles is exact; straight
// lines lose (2 pi / 500)^2 / 6 = 2.6e-5.
TEST(AriasIntensity, OfASine) {
  const Sine s;
  const double exact = kPi / (2 * kStandardGravity) * 4 * 10 / 2;
  EXPECT_NEAR(arias_intensity(s.kStep, s.a), exact, 1e-12);
  const double lines = arias_intensity(s.kStep, s.a, Rule::kExact);
  EXPECT_NEAR(lines, exact * (1 - std::pow(2 * kPi / 500, 2) / 6), 1e-8 * exact);
}

TEST(AriasIntensity, OfAStraightLine) {  // int t^2 dt from 0 to 3 is 9, by the trapezoid 9.5
  const VectorXd a = VectorXd::LinSpaced(4, 0, 3);
  const double factor = kPi / (2 * kStandardGravity);
  EXPECT_DOUBLE_EQ(arias_intensity(1, a, Rule::kExact), 9 * factor);
  EXPECT_DOUBLE_EQ(arias_intensity(1, a), 9.5 * factor);
}

// int |a| = 2 A D / pi; the trapezoid loses (pi / 250)^2 / 12 = 1.3e-5 of it, as do the lines,
// which meet zero at the samples.
TEST(CumulativeAbsoluteVelocity, OfASine) {
  const Sine s;
  const double exact = 2 * 2 * 10 / kPi;
  EXPECT_NEAR(cumulative_absolute_velocity(s.kStep, s.a), exact * (1 - 1.316e-5), 1e-8 * exact);
  EXPECT_NEAR(cumulative_absolute_velocity(s.kStep, s.a, Rule::kExact),
              cumulative_absolute_velocity(s.kStep, s.a), 1e-10);
}

TEST(CumulativeAbsoluteVelocity, CutsLinesWhereTheyCrossZero) {
  VectorXd a(2);
  a << 3, -1;  // triangles 3 * 0.75 / 2 and 1 * 0.25 / 2
  EXPECT_DOUBLE_EQ(cumulative_absolute_velocity(1, a, Rule::kExact), 1.25);
  EXPECT_DOUBLE_EQ(cumulative_absolute_velocity(1, a), 2);
}

// A constant from 2 to 12 s: the Husid curve is a line but for half a step at each end, which the
// trapezoid adds: 10 s + one step in all.
TEST(SignificantPart, OfABoxcar) {
  const double dt = 0.01;
  VectorXd a = VectorXd::Zero(2001);
  a.segment(200, 1001).setConstant(-1.5);
  const auto d595 = significant_part(dt, a, 0.05, 0.95), d575 = significant_part(dt, a, 0.05, 0.75);
  EXPECT_NEAR(d595.duration(), 0.9 * 10.01, 1e-9);
  EXPECT_NEAR(d575.duration(), 0.7 * 10.01, 1e-9);
  EXPECT_NEAR(d595.begin, 2 - dt / 2 + 0.05 * 10.01, 1e-9);
}

TEST(SignificantPart, OfNothingIsEmpty) {
  EXPECT_EQ(significant_part(0.01, VectorXd::Zero(10), 0.05, 0.95).duration(), 0);
  EXPECT_EQ(significant_part(0.01, VectorXd(), 0.05, 0.95).duration(), 0);
}

}  // namespace
}  // namespace gurney::groundmotions
