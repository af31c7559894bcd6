#include "engine/record/run_clock.h"

#include <gtest/gtest.h>

#include <vector>

namespace gurney {
namespace {

SimulationSettings settings(double duration) {
  SimulationSettings s;
  s.time_step = 0.01;
  s.history_step = 0.03;
  s.duration = duration;
  return s;
}

TEST(RunClock, StopsOnTheGridAndAtTheEnd) {
  RunClock clock({}, {}, settings(0.035));
  std::vector<double> stops;
  double time = 0;
  while (clock.next(time)) stops.push_back(time = clock.target());
  ASSERT_EQ(stops.size(), 4u);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(stops[static_cast<std::size_t>(i)], 0.01 * (i + 1), 1e-15);
  EXPECT_EQ(stops[3], 0.035);
  EXPECT_EQ(clock.outcome(), Outcome::kStopped);
}

TEST(RunClock, StopsWhereALoadChangesAndReturnsToTheGrid) {
  RunClock clock({}, {0.014, 0.02}, settings(0.04));
  std::vector<double> stops;
  std::vector<bool> breaks;
  double time = 0;
  while (clock.next(time)) {
    stops.push_back(time = clock.target());
    breaks.push_back(clock.at_breakpoint());
  }
  ASSERT_EQ(stops.size(), 5u);
  EXPECT_EQ(stops[1], 0.014);
  EXPECT_NEAR(stops[2], 0.02, 1e-15);
  EXPECT_EQ(breaks, (std::vector<bool>{false, true, true, false, false}));
}

TEST(RunClock, SamplesAreDueEveryHistoryStep) {
  RunClock clock({}, {0.0155}, settings(0.09));
  std::vector<double> due;
  double time = 0;
  while (clock.next(time)) {
    time = clock.target();
    if (clock.sample_due()) due.push_back(time);
  }
  ASSERT_EQ(due.size(), 3u);
  EXPECT_NEAR(due[0], 0.03, 1e-12);
  EXPECT_NEAR(due[2], 0.09, 1e-12);
}

// An item that blocks hold still for longer than the hold must still be let go.
TEST(RunClock, CountsRestFromTheEndOfTheExcitation) {
  const FloorMotion floor = FloorMotion(1, Eigen::Matrix3Xd::Zero(3, 3));  // until 2 s
  SimulationSettings s = settings(0);
  s.rest_hold = 0.5;
  s.settle_time = 10;
  RunClock clock(floor, {}, s);
  double time = 0;
  while (clock.next(time)) {
    time = clock.target();
    clock.observe(time, {{time < 1.8 ? 1.0 : 0.0, 0, 0}});
  }
  EXPECT_EQ(clock.outcome(), Outcome::kRested);
  EXPECT_NEAR(time, 2.5, 1e-9);
}

// 1 mm/s2 from rest is below the rest speed for the whole hold, but it is not rest.
TEST(RunClock, DoesNotTakeASlowStartForRest) {
  SimulationSettings s = settings(0);
  s.rest_hold = 0.5;
  s.settle_time = 3;
  RunClock clock({}, {}, s);
  double time = 0;
  while (clock.next(time)) {
    time = clock.target();
    clock.observe(time, {{1e-3 * time, 1e-3 * time, 0}});
  }
  EXPECT_EQ(clock.outcome(), Outcome::kStillMoving);
}

TEST(RunClock, GivesUpWaitingForRestAtTheSettleTime) {
  SimulationSettings s = settings(0);
  s.settle_time = 0.2;
  RunClock clock({}, {0.1}, s);
  double time = 0;
  while (clock.next(time)) clock.observe(time = clock.target(), {{1, 1, 0}});
  EXPECT_EQ(clock.outcome(), Outcome::kStillMoving);
  EXPECT_NEAR(time, 0.3, 1e-12);
}

TEST(RunClock, EndsAtOverturningAndAtACause) {
  SimulationSettings s = settings(1);
  s.follow_overturning = false;
  RunClock clock({}, {}, s);
  ASSERT_TRUE(clock.next(0));
  clock.observe(0.01, {{1, 1, 1.05}});
  EXPECT_EQ(clock.outcome(), Outcome::kOverturned);
  EXPECT_FALSE(clock.next(0.01));
  EXPECT_EQ(clock.overturned_at(0), 0.01);
  RunClock failed({}, {}, settings(1));
  failed.stop(Outcome::kDiverged, "because");
  EXPECT_FALSE(failed.next(0));
  EXPECT_EQ(failed.cause(), "because");
}

TEST(RunClock, GoesOnWhereWhatStandsOnAnItemTopples) {
  SimulationSettings s = settings(1);
  s.follow_overturning = false;
  RunClock clock({}, {}, s);
  ASSERT_TRUE(clock.next(0));
  clock.observe(0.01, {{1, 1, 0}, {1, 1, 1.05, true}});
  EXPECT_EQ(clock.overturned_at(1), 0.01);
  EXPECT_TRUE(clock.next(0.01));
  EXPECT_EQ(clock.outcome(), Outcome::kStopped);
}

TEST(RunClock, FollowsAnOverturnedItemUntilItRests) {
  SimulationSettings s = settings(0);
  RunClock clock({}, {}, s);
  double time = 0;
  while (clock.next(time)) {
    time = clock.target();
    clock.observe(time, {{time < 1 ? 1.0 : 0.0, time < 1 ? 1.0 : 0.0, 1.6}});
  }
  EXPECT_EQ(clock.outcome(), Outcome::kOverturned);
  EXPECT_NEAR(time, 1 + s.rest_hold, 2 * s.time_step);
  EXPECT_NEAR(clock.overturned_at(0), s.time_step, 1e-12);
}

}  // namespace
}  // namespace gurney
