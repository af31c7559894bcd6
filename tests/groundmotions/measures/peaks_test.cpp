#include "groundmotions/measures/peaks.h"

#include <gtest/gtest.h>

namespace gurney::groundmotions {
namespace {

// a falls linearly from 2 to -2 over 4 s in steps of 1 s: v = 2 t - t^2 / 2, largest 2 at 2 s,
// back to 0 at 4 s; d = t^2 - t^3 / 6 = 16/3 at 4 s. The integrals are exact.
TEST(Peaks, AreThoseOfTheExactIntegrals) {
  const Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(5, 2, -2);
  const Peaks p = peaks(1, a);
  EXPECT_EQ(p.acceleration, 2);
  EXPECT_EQ(p.time_of_acceleration, 0);
  EXPECT_DOUBLE_EQ(p.velocity, 2);
  EXPECT_DOUBLE_EQ(p.displacement, 16.0 / 3);
}

TEST(Peaks, TakesMagnitudesAndTheFirstOfEquals) {
  Eigen::VectorXd a(4);
  a << 0, -3, 1, 3;
  const Peaks p = peaks(0.5, a);
  EXPECT_EQ(p.acceleration, 3);
  EXPECT_EQ(p.time_of_acceleration, 0.5);
  EXPECT_DOUBLE_EQ(p.velocity, 1.25);  // |(0 - 3) / 4 + (-3 + 1) / 4|, at the third sample
}

// (3, 4) times a history: 5 times its peaks; and a turning vector keeps its length.
TEST(Peaks, OfResultantsAreLengths) {
  const Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(5, 2, -2);
  const Peaks p = peaks(1, 3 * a, 4 * a);
  EXPECT_DOUBLE_EQ(p.acceleration, 10);
  EXPECT_DOUBLE_EQ(p.velocity, 10);
  EXPECT_DOUBLE_EQ(p.displacement, 5 * 16.0 / 3);
  EXPECT_EQ(peaks(1, Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)).acceleration, 1);
}

TEST(Peaks, OfNothingAreZero) { EXPECT_EQ(peaks(0.01, Eigen::VectorXd()).acceleration, 0); }

}  // namespace
}  // namespace gurney::groundmotions
