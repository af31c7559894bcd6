#include "studies/report/fall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/fabricated_ward.h"

namespace gurney::report {
namespace {

constexpr double kPi = std::numbers::pi, kStep = 0.005;

/// a sin(2 pi t / T) along `direction` for one period, then at rest.
FloorMotion one_sine(double a, double period, const Vector2& direction) {
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, 1001);
  for (int i = 0; i * kStep <= period; ++i)
    motion.col(i).head<2>() = a * std::sin(2 * kPi * i * kStep / period) * direction;
  return {kStep, motion};
}

TEST(LargestPulse, IsTheHalfSineThatPushes) {
  const Vector2 d(0.6, 0.8);
  const FloorMotion floor = one_sine(3, 2, d);
  // A half sine changes the velocity by a T / pi; the trapezoids of the samples miss
  // (pi dt / T)^2 / 3 = 2e-5 of it.
  const auto pushes = largest_pulse(floor, d, 0, 5);
  ASSERT_TRUE(pushes);
  EXPECT_NEAR(pushes->velocity_change, 6 / kPi, 1e-4);
  EXPECT_NEAR(pushes->start, 0, 1e-9);
  EXPECT_NEAR(pushes->end, 1, kStep);
  EXPECT_NEAR(pushes->peak_acceleration, 3, 1e-9);
  EXPECT_NEAR(pushes->time_of_peak, 0.5, 1e-9);
  // The other way round it is the second half that pushes.
  const auto pulls = largest_pulse(floor, -d, 0, 5);
  ASSERT_TRUE(pulls);
  EXPECT_NEAR(pulls->velocity_change, 6 / kPi, 1e-4);
  EXPECT_NEAR(pulls->start, 1, kStep);
  EXPECT_NEAR(pulls->time_of_peak, 1.5, 1e-9);
}

TEST(LargestPulse, StaysInItsWindowAndDirection) {
  const FloorMotion floor = one_sine(3, 2, {1, 0});
  const auto part = largest_pulse(floor, {1, 0}, 0.5, 0.752);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->start, 0.5);
  EXPECT_EQ(part->end, 0.752);
  EXPECT_NEAR(part->velocity_change, 3 / kPi * std::sin(kPi * 0.252), 1e-3);
  EXPECT_FALSE(largest_pulse(floor, {1, 0}, 1.1, 1.9)) << "it only falls there";
  EXPECT_FALSE(largest_pulse(floor, {0, 1}, 0, 5)) << "nothing moves across";
  EXPECT_FALSE(largest_pulse(floor, {1, 0}, 3, 2)) << "no window";
  EXPECT_FALSE(largest_pulse({}, {1, 0}, 0, 5)) << "a floor at rest";
}

TEST(Falls, LookAgainstTheFall) {
  const study::RunFacts facts = fabricated_ward();
  Response response = fabricated_ward_response();
  const auto all = falls(facts, response);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].item, 3u);
  ASSERT_EQ(all[0].liftoffs.size(), 3u);
  EXPECT_EQ(all[0].liftoffs[1].wheel, "rear left") << "by time";
  ASSERT_TRUE(all[0].pulse) << "the floor moves towards +y, the item falls towards -y";
  EXPECT_NEAR(all[0].pulse->velocity_change, 4 / kPi, 1e-3);
  // Without casters the look starts 1 s before the tilt last was below 1 degree, about 4.1 s.
  Response block = response;
  for (WheelDemands& wheel : block.items[3].demands.wheels) wheel.liftoff_before_overturning = -1;
  block.items[3].demands.time_of_overturning = 5.75;  // later than 1 s after the floor's pulse
  ASSERT_TRUE(falls(facts, block)[0].pulse);
  EXPECT_NEAR(falls(facts, block)[0].pulse->velocity_change, 4 / kPi, 1e-3);
  response.items[3].demands.direction_of_overturning *= -1;
  EXPECT_FALSE(falls(facts, response)[0].pulse) << "the floor never moves towards -y";
  response.outcome = Outcome::kDiverged;
  EXPECT_TRUE(falls(facts, response).empty());
}

}  // namespace
}  // namespace gurney::report
