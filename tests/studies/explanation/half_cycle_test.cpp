#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "studies/explanation/overturning.h"

namespace gurney::explanation {
namespace {

constexpr double kPi = std::numbers::pi, kStep = 0.005;

/// a sin(2 pi t / T) along `direction` for one period, then at rest.
FloorMotion one_sine(double a, double period, const Vector2& direction) {
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, 1001);
  for (int i = 0; i * kStep <= period; ++i)
    motion.col(i).head<2>() = a * std::sin(2 * kPi * i * kStep / period) * direction;
  return {kStep, motion};
}

TEST(HalfCycle, IsTheHalfSineThatPushes) {
  const Vector2 d(0.6, 0.8);
  const FloorMotion floor = one_sine(3, 2, d);
  // A half sine changes the velocity by a T / pi; the trapezoids of the samples miss
  // (pi dt / T)^2 / 3 = 2e-5 of it. At its ends up to 1 % of the peak is cut off:
  // t = T / (2 pi) asin(0.01) = 3.2 ms, less than a sample.
  const auto pushes = driving_half_cycle(floor, d, 0, 5);
  ASSERT_TRUE(pushes);
  EXPECT_EQ(pushes->direction, d);
  EXPECT_NEAR(pushes->velocity_change, 6 / kPi, 1e-4);
  EXPECT_NEAR(pushes->peak_velocity, 6 / kPi, 1e-4) << "it starts from rest";
  EXPECT_NEAR(pushes->start, 0, 1e-9);
  EXPECT_NEAR(pushes->end, 1, kStep);
  EXPECT_NEAR(pushes->peak_acceleration, 3, 1e-9);
  EXPECT_NEAR(pushes->time_of_peak, 0.5, 1e-9);
  // The other way round it is the second half that pushes.
  const auto pulls = driving_half_cycle(floor, -d, 0, 5);
  ASSERT_TRUE(pulls);
  EXPECT_NEAR(pulls->velocity_change, 6 / kPi, 1e-4);
  EXPECT_NEAR(pulls->start, 1, kStep);
  EXPECT_NEAR(pulls->time_of_peak, 1.5, 1e-9);
}

TEST(HalfCycle, EndsDuringTheMotionOrShortlyBefore) {
  const FloorMotion floor = one_sine(3, 2, {1, 0});
  const auto goes_on = driving_half_cycle(floor, {1, 0}, 0.5, 0.752);
  ASSERT_TRUE(goes_on);
  EXPECT_NEAR(goes_on->start, 0, 1e-9);
  EXPECT_EQ(goes_on->end, 0.75) << "the last sample";
  const auto before = driving_half_cycle(floor, {1, 0}, 1.9, 2.5);
  ASSERT_TRUE(before);
  EXPECT_NEAR(before->end, 1, kStep);
  EXPECT_EQ(driving_half_cycle(floor, {1, 0}, 1.9, 1.9)->end, before->end) << "a moment";
  EXPECT_FALSE(driving_half_cycle(floor, {1, 0}, 2.1, 2.9)) << "more than 1 s before";
  EXPECT_FALSE(driving_half_cycle(floor, {0, 1}, 0, 5)) << "nothing moves across";
}

TEST(HalfCycle, IsOneHalfOfAWaveThatGoesOn) {
  // Waves of 1 s and 3 m/s2, the third of 4 m/s2, with a ripple of 20 Hz and 6 m/s2 on top, whose
  // velocity goes up and down by r = 6 / (40 pi) = 0.048 m/s: no reversal of 20 % of 4 / pi.
  constexpr double kRipple = 6 / (40 * kPi);
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, 2001);
  for (int i = 0; i <= 1000; ++i) {
    const double t = i * 0.005;
    motion(0, i) = (t >= 2 && t < 3 ? 4 : 3) * std::sin(2 * kPi * t) + 6 * std::sin(40 * kPi * t);
  }
  const FloorMotion floor(0.005, motion);
  const auto found = driving_half_cycle(floor, {1, 0}, 1.9, 2.9);
  ASSERT_TRUE(found);
  // The ripple moves a turning point while A / (2 pi) (1 - cos(2 pi d)) < 2 r, here of A = 3.
  const double moved = std::acos(1 - 2 * kRipple * 2 * kPi / 3) / (2 * kPi);
  EXPECT_NEAR(found->start, 2, moved);
  EXPECT_NEAR(found->end, 2.5, moved);
  EXPECT_NEAR(found->velocity_change, 4 / kPi, 2 * kRipple) << "A T / pi";
  EXPECT_NEAR(found->time_of_peak, 2.25, 0.05) << "within a period of the ripple";
  const auto other = driving_half_cycle(floor, {-1, 0}, 2.1, 2.9);
  ASSERT_TRUE(other);
  EXPECT_NEAR(other->start, 2.5, moved);
  EXPECT_FALSE(driving_half_cycle(floor, {0, 1}, 1, 3)) << "nothing moves across";
  EXPECT_FALSE(driving_half_cycle(floor, {1, 0}, 8, 9)) << "the floor is at rest again";
  EXPECT_FALSE(driving_half_cycle({}, {1, 0}, 0, 1));
}

}  // namespace
}  // namespace gurney::explanation
