#include "engine/response/settled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/error.h"

namespace gurney {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity(), kNone = std::nan("");

TEST(RelativeChange, IsOfTheLargerValueAndOfNothingLessThanIsAskedFor) {
  EXPECT_DOUBLE_EQ(relative_change("peak_yaw", "rad", 0.1, 0.08), -0.2);
  EXPECT_DOUBLE_EQ(relative_change("peak_yaw", "rad", 0.08, 0.1), 0.2);
  EXPECT_DOUBLE_EQ(relative_change("residual_yaw", "rad", 0.1, -0.1), -2);
  EXPECT_DOUBLE_EQ(relative_change("residual_displacement", "m", 0, 1e-5), 0.01);
  EXPECT_DOUBLE_EQ(relative_change("impacts", "1", 0, 1), 1);
  EXPECT_DOUBLE_EQ(relative_change("impacts", "1", 7, 8), 0.125);
}

TEST(RelativeChange, OfWhatIsInOneRunOnlyIsInfinite) {
  EXPECT_EQ(relative_change("time_of_overturning", "s", kNone, kNone), 0);
  EXPECT_EQ(relative_change("time_of_overturning", "s", kNone, 3), kInfinite);
  EXPECT_EQ(relative_change("time_of_overturning", "s", 3, kNone), kInfinite);
}

TEST(RelativeChange, OfADirectionGoesTheShortWayRound) {
  constexpr double kPi = std::numbers::pi;
  EXPECT_NEAR(relative_change("direction_of_overturning", "rad", kPi - 0.01, 0.01 - kPi), 0.02,
              1e-15);
}

TEST(RelativeChange, KnowsEveryUnit) {
  Demands demands;
  demands.wheels.resize(1);
  demands.points.resize(1);
  for (const DemandNumber& number : numbers_of(demands))
    EXPECT_GT(size_of_interest(number.units), 0) << number.name;
  EXPECT_THROW(size_of_interest("K"), Error);
}

/// A run whose peak yaw changes with half the step and by the twin.
SettledDemand yaw(double step_change, double twin_change) {
  ItemResponse item;
  item.demands.peak_yaw = 1;
  Predictability& p = item.predictability.emplace();
  p.half_step = p.twin = item.demands;
  p.half_step->peak_yaw -= step_change;
  p.twin->peak_yaw -= twin_change;
  for (const SettledDemand& each : settled_demands(item))
    if (std::string_view(each.number.name) == "peak_yaw") return each;
  ADD_FAILURE();
  return {};
}

TEST(SettledDemand, IsOfTheLeastFractionThatFourTimesItsChangeIsWithin) {
  EXPECT_EQ(yaw(0, 0).within(), 0.01);
  EXPECT_EQ(yaw(0.0024, 0).within(), 0.01);
  EXPECT_EQ(yaw(-0.0024, 0).within(), 0.01);
  EXPECT_EQ(yaw(0.0026, 0).within(), 0.02);
  EXPECT_EQ(yaw(0.0124, 0).within(), 0.05);
  EXPECT_EQ(yaw(0.0249, 0).within(), 0.1);
  EXPECT_EQ(yaw(0.0251, 0).within(), kInfinite);
  EXPECT_FALSE(yaw(0.0251, 0).settled());
}

TEST(SettledDemand, IsNoneThatAChangeOfMassMoves) {
  EXPECT_EQ(yaw(0, 0.9e-6).within(), 0.01);
  EXPECT_EQ(yaw(0, 1.1e-6).within(), kInfinite) << "grown by more than 1000";
  EXPECT_FALSE(yaw(0, 1.1e-6).predictable());
}

const SettledDemand& find(const std::vector<SettledDemand>& all, std::string_view name) {
  const auto found = std::ranges::find_if(
      all, [&](const SettledDemand& each) { return each.number.name == name; });
  if (found == all.end()) throw Error("no " + std::string(name));
  return *found;
}

/// A run whose numbers are all 1 and the same at half the step and of the twin.
ItemResponse steady() {
  ItemResponse item;
  Demands& d = item.demands;
  for (double* each : {&d.peak_displacement, &d.peak_yaw, &d.peak_tilt, &d.peak_velocity})
    *each = 1;
  d.time_of_peak_displacement = 1;
  d.impacts = 20;
  d.most_wheels_lifted = 2;
  d.wheels.resize(1);
  Predictability& p = item.predictability.emplace();
  p.half_step = p.twin = d;
  return item;
}

// An equal number of events leaves open how many come and go at the next step.
TEST(SettledDemand, IsNoNumberOfEventsButNone) {
  const std::vector<SettledDemand> all = settled_demands(steady());
  EXPECT_EQ(find(all, "impacts").step_change, 0);
  EXPECT_FALSE(find(all, "impacts").settled());
  EXPECT_EQ(find(all, "liftoffs").within(), 0.01) << "there is none in either run";
  EXPECT_EQ(find(all, "most_wheels_lifted").within(), 0.01) << "the wheels are few";
}

// Seven numbers are something; the larger changes of two of them are the upper quartile.
TEST(SettledDemand, IsNotAmongOthersThatChangeByMuch) {
  ItemResponse item = steady();
  const auto within = [&](double change_of_two) {
    item.predictability->half_step->peak_yaw = item.predictability->half_step->peak_tilt =
        1 - change_of_two;
    const std::vector<SettledDemand> all = settled_demands(item);
    EXPECT_EQ(find(all, "liftoffs").within(), 0.01) << "nothing stays nothing";
    return find(all, "peak_displacement").within();
  };
  EXPECT_EQ(within(0.0096), 0.01);
  EXPECT_EQ(within(0.0104), 0.02);
  EXPECT_EQ(within(0.096), 0.1);
  EXPECT_EQ(within(0.104), kInfinite);
  item.demands.time_of_overturning = item.predictability->half_step->time_of_overturning =
      item.predictability->twin->time_of_overturning = 1;
  within(0.104);
  EXPECT_EQ(find(settled_demands(item), "time_of_overturning").within(), 0.01)
      << "the item had overturned before the others changed";
}

TEST(SettledDemands, AreThoseOfWheelsAndPointsTooAndNoneWithoutARepetition) {
  ItemResponse item;
  item.demands.wheels.resize(4);
  item.demands.points.resize(2);
  EXPECT_TRUE(settled_demands(item).empty());
  Predictability& p = item.predictability.emplace();
  p.twin = item.demands;
  EXPECT_TRUE(settled_demands(item).empty());
  p.half_step = item.demands;
  p.half_step->points[1].peak_absolute_acceleration = 3;
  p.half_step->points[1].numerical_acceleration = 1e4;
  int unsettled = 0;
  for (const SettledDemand& each : settled_demands(item)) {
    if (each.settled()) continue;
    ++unsettled;
    EXPECT_EQ(each.number.of, DemandNumber::Of::kPoint);
    EXPECT_EQ(each.number.part, 1u);
    EXPECT_STREQ(each.number.name, "peak_absolute_acceleration");
  }
  EXPECT_EQ(unsettled, 1) << "numerical accelerations are no demand";
}

}  // namespace
}  // namespace gurney
