#include "studies/explanation/overturning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/synthetic_ward.h"

namespace gurney::explanation {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Overturnings, LookAgainstTheirDirection) {
  const study::RunFacts facts = synthetic_ward();
  Response response = synthetic_ward_response();
  const auto all = overturnings_of(facts, response);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].item, 3u);
  EXPECT_FALSE(all[0].topples);
  ASSERT_EQ(all[0].liftoffs.size(), 3u);
  EXPECT_EQ(all[0].liftoffs[1].wheel, "rear left") << "by time";
  ASSERT_TRUE(all[0].half_cycle) << "the floor moves towards +y, the item falls towards -y";
  EXPECT_NEAR(all[0].half_cycle->velocity_change, 4 / kPi, 1e-3);
  // Without casters the look starts 1 s before the tilt last was below 1 degree, about 4.1 s.
  Response block = response;
  for (WheelDemands& wheel : block.items[3].demands.wheels) wheel.liftoff_before_overturning = -1;
  block.items[3].demands.time_of_overturning = 5.75;  // later than 1 s after the floor's pulse
  ASSERT_TRUE(overturnings_of(facts, block)[0].half_cycle);
  EXPECT_NEAR(overturnings_of(facts, block)[0].half_cycle->velocity_change, 4 / kPi, 1e-3);
  response.items[3].demands.direction_of_overturning *= -1;
  EXPECT_FALSE(overturnings_of(facts, response)[0].half_cycle)
      << "the floor never moves towards -y";
  std::swap(response.items[3].demands.time_of_overturning,
            response.items[3].demands.time_of_toppling);
  EXPECT_TRUE(overturnings_of(facts, response).at(0).topples);
  EXPECT_EQ(overturnings_of(facts, response)[0].time, all[0].time);
  response.outcome = Outcome::kDiverged;
  EXPECT_TRUE(overturnings_of(facts, response).empty());
}

}  // namespace
}  // namespace gurney::explanation
