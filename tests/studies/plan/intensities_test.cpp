#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "studies/plan/stages.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;

IntensityPlan ida(int most_runs, double resolution = 0.1) {
  IntensityPlan plan;
  plan.kind = IntensityPlan::Kind::kIda;
  plan.first = 1;
  plan.increment = 0.5;
  plan.most_runs = most_runs;
  plan.resolution = resolution;
  return plan;
}

std::vector<double> tried(const IntensityPlan& plan, const std::function<bool(double)>& exceeds) {
  Intensities intensities(plan);
  std::vector<double> values;
  while (const auto value = intensities.next()) {
    values.push_back(*value);
    intensities.report(*value, exceeds(*value));
  }
  return values;
}

TEST(Intensities, LevelsComeInTheirOrderWhateverHappens) {
  IntensityPlan plan;
  plan.kind = IntensityPlan::Kind::kStripes;
  plan.levels = {0.1, 0.2, 0.4};
  EXPECT_THAT(tried(plan, [](double) { return true; }), ElementsAre(0.1, 0.2, 0.4));
}

TEST(Intensities, AnIdaTakesStepsThatGrow) {
  EXPECT_THAT(tried(ida(5), [](double) { return false; }), ElementsAre(1, 1.5, 2.5, 4, 6));
}

TEST(Intensities, AnIdaHalvesTheBracketUntilItIsNarrow) {
  // Capacity 3.3: 4 exceeds; then halves of (2.5, 4): 3.25 is safe, (3.25, 4): 3.625 exceeds, and
  // 0.375 > 0.1 x 3.25 goes on: 3.4375 exceeds, and 0.1875 <= 0.325 ends it.
  EXPECT_THAT(tried(ida(50), [](double x) { return x > 3.3; }),
              ElementsAre(1, 1.5, 2.5, 4, 3.25, 3.625, 3.4375));
}

TEST(Intensities, AnIdaFillsTheWidestGapsBelowTheCapacity) {
  // As above, then: gaps of 1, 0.5, 1, 0.75 and 0.19 below 3.4375; the first of the widest, from 0
  // to 1, gives 0.5; the next, from 1.5 to 2.5, gives 2.
  IntensityPlan plan = ida(50);
  plan.fill = 2;
  EXPECT_THAT(tried(plan, [](double x) { return x > 3.3; }),
              ElementsAre(1, 1.5, 2.5, 4, 3.25, 3.625, 3.4375, 0.5, 2));
  // A fill that exceeds lowers the capacity, below which the next one is.
  EXPECT_THAT(tried(plan, [](double x) { return x > 3.3 || x == 0.5; }),
              ElementsAre(1, 1.5, 2.5, 4, 3.25, 3.625, 3.4375, 0.5, 0.25));
}

TEST(Intensities, AnIdaEndsWithTheRunsItMayMake) {
  EXPECT_THAT(tried(ida(5), [](double x) { return x > 3.3; }), ElementsAre(1, 1.5, 2.5, 4, 3.25));
}

TEST(Intensities, AnIdaThatFailsAtOnceGoesDown) {
  // Capacity 0.2: 1, 0.5, 0.25 exceed, 0.125 is safe; 0.1875 is safe; 0.0625 / 0.1875 > 0.1:
  // 0.21875 exceeds, 0.03125 / 0.1875 > 0.1: 0.203125 exceeds, 0.015625 / 0.1875 <= 0.1.
  EXPECT_THAT(tried(ida(50), [](double x) { return x > 0.2; }),
              ElementsAre(1, 0.5, 0.25, 0.125, 0.1875, 0.21875, 0.203125));
}

TEST(Intensities, OfAResurrectionTheLowestExceedanceCounts) {
  // Exceeded from 1.2 to 2 and again from 5: the bracket (1, 1.5) is found first.
  const auto values = tried(ida(50, 0.2), [](double x) { return (x > 1.2 && x < 2) || x > 5; });
  EXPECT_THAT(values, ElementsAre(1, 1.5, 1.25, 1.125));
  // Reported from outside: what is safe above an exceedance does not lift the bracket.
  const IntensityPlan plan = ida(50);
  Intensities intensities(plan);
  intensities.report(1, false);
  intensities.report(2, true);
  intensities.report(3, false);
  EXPECT_EQ(intensities.next(), 1.5);
}

TEST(Intensities, NothingComesAfterAFailure) {
  IntensityPlan scales;
  scales.levels = {1, 2, 3};
  for (const IntensityPlan& plan : {ida(50), scales}) {
    Intensities intensities(plan);
    ASSERT_EQ(intensities.next(), 1);
    intensities.report(1, false);
    intensities.stop();
    EXPECT_FALSE(intensities.next());
  }
}

}  // namespace
}  // namespace gurney::study
