#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "groundmotions/measures/peaks.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kStep = 0.01;
constexpr int kSamples = 4001;  // 40 s

/// A whole number of sine waves in velocity, so that velocity and displacement end at zero, plus a
/// constant offset of the acceleration.
FloorMotion wave(double offset) {
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, kSamples);
  for (int i = 0; i < kSamples; ++i)
    a(0, i) = 3 * std::sin(2 * std::numbers::pi * i * kStep) *
                  std::sin(std::numbers::pi * i / (kSamples - 1)) +
              offset;
  return FloorMotion(kStep, a);
}

TEST(Residual, OfARecordThatEndsAtRestIsPlausible) {
  const Residual r = residual(wave(0));
  // The integral of sin sin over whole waves is zero up to the error of the trapezoid, < 1e-4.
  EXPECT_LT(r.velocity.norm(), 1e-4);
  EXPECT_THAT(r.warnings, IsEmpty());
  EXPECT_TRUE(r.warnings.empty());
}

// v = a T = 0.001 g * 40 s = 0.3923 m/s and d = a T^2 / 2 = 7.845 m.
TEST(Residual, OfAnOffsetOfAThousandthOfGIsNot) {
  const Residual r = residual(wave(0.001 * kStandardGravity));
  EXPECT_NEAR(r.velocity.x(), 0.39227, 2e-4);
  EXPECT_NEAR(r.displacement.x(), 7.8453, 0.05 * 7.8453);
  EXPECT_THAT(
      r.warnings,
      ElementsAre(HasSubstr("the floor still moves at 0.392 m/s when the record ends (0.0392 "
                            "m/s are plausible after 40 s): the same as a constant baseline "
                            "error of 0.001 g, which alone carries a free roller 7.8 m"),
                  HasSubstr("the floor ends 7.")));
}

// The limit after 40 s is 0.0001 g * 40 s: an offset of 0.0001 g is the edge.
TEST(Residual, HasItsVelocityLimitAtATenThousandthOfG) {
  const auto velocity_warnings = [](double offset_g) {
    int count = 0;
    for (const auto& warning : residual(wave(offset_g * kStandardGravity)).warnings)
      count += warning.find("still moves") != std::string::npos;
    return count;
  };
  EXPECT_EQ(velocity_warnings(0.9e-4), 0);
  EXPECT_EQ(velocity_warnings(1.1e-4), 1);
}

TEST(Residual, LeavesAShortPulseOfInvisibleVelocityAlone) {
  // 0.05 m/s2 for 0.1 s leave 0.005 m/s; for 0.4 s they leave 0.02 m/s.
  EXPECT_TRUE(residual(FloorMotion(0.1, Eigen::Matrix3Xd::Constant(3, 2, 0.03))).warnings.empty());
  EXPECT_FALSE(residual(FloorMotion(0.1, Eigen::Matrix3Xd::Constant(3, 5, 0.05))).warnings.empty());
}

TEST(Residual, WarnsOfAFloorThatDoesNotComeBack) {
  // +1, -1 m/s2 for 1 s each: 1 m away and at rest; 0.01 of it is 0.01 m, which is not visible.
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, 201);
  a.row(1).segment(1, 99).setConstant(1);
  a.row(1).segment(101, 99).setConstant(-1);
  EXPECT_THAT(residual(FloorMotion(0.01, a)).warnings,
              ElementsAre(HasSubstr("the floor ends 0.99 m from where it began (its largest "
                                    "displacement is 0.99 m)")));
  EXPECT_TRUE(residual(FloorMotion(0.01, 0.01 * a)).warnings.empty());
}

TEST(Residual, OfAFloorAtRestIsZero) { EXPECT_TRUE(residual(FloorMotion()).warnings.empty()); }

TEST(Residual, JudgesTheHorizontalsOnly) {
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, 101);
  a.row(2).setConstant(1);
  const Residual r = residual(FloorMotion(0.01, a));
  EXPECT_NEAR(r.velocity.z(), 1, 1e-12);
  EXPECT_TRUE(r.warnings.empty());
}

}  // namespace
}  // namespace gurney::groundmotions
