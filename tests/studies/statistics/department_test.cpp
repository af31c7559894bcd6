#include "studies/statistics/department.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/expect_error.h"

namespace gurney::statistics {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

TEST(Levels, AreDifferencesOfExceedance) {
  const auto levels = level_probabilities({0.6, 0.25, 0.1});
  EXPECT_THAT(levels.of_level, Pointwise(DoubleNear(1e-15), {0.4, 0.35, 0.15, 0.1}));
  EXPECT_FALSE(levels.crossed);
}

TEST(Levels, ThatCrossAreCutAndSaidSo) {
  const auto levels = level_probabilities({0.2, 0.3});
  EXPECT_TRUE(levels.crossed);
  EXPECT_THAT(levels.of_level, Pointwise(DoubleNear(1e-15), {0.8, 0.0, 0.2}));
  EXPECT_THAT(level_probabilities({}).of_level, ElementsAre(1));
  EXPECT_ERROR(level_probabilities({0.5, 1.1}), "probability[1] = 1.1 must be within [0, 1]");
}

TEST(Combine, GivesIndependenceAndBounds) {
  const auto both = combine({0.3, 0.8});
  EXPECT_NEAR(both.expected_number, 1.1, 1e-15);
  EXPECT_NEAR(both.any_independent, 0.86, 1e-15);
  EXPECT_NEAR(both.all_independent, 0.24, 1e-15);
  EXPECT_NEAR(both.any.low, 0.8, 1e-15);
  EXPECT_NEAR(both.any.high, 1, 1e-15);
  EXPECT_NEAR(both.all.low, 0.1, 1e-15);
  EXPECT_NEAR(both.all.high, 0.3, 1e-15);
  EXPECT_THAT(both.number_independent, Pointwise(DoubleNear(1e-15), {0.14, 0.62, 0.24}));
  // Five alike are binomial: 10 * 0.2^2 * 0.8^3 for two.
  EXPECT_NEAR(combine(std::vector<double>(5, 0.2)).number_independent[2], 0.2048, 1e-15);
  EXPECT_ERROR(combine({std::nan("")}), "probability[0] = nan");
}

TEST(JointOutcomes, CountRunsNotItems) {
  const auto joint = joint_outcomes({{true, true}, {false, false}, {true, false}, {false, false}});
  EXPECT_EQ(joint.any, 0.5);
  EXPECT_EQ(joint.all, 0.25);
  EXPECT_EQ(joint.mean_number, 0.75);
  EXPECT_THAT(joint.number, ElementsAre(0.5, 0.25, 0.25));
  // Items that fail together lie on the bound of the combination of their fractions.
  const auto together = joint_outcomes({{true, true}, {false, false}});
  EXPECT_EQ(together.any, combine({0.5, 0.5}).any.low);
  EXPECT_ERROR(joint_outcomes({}), "there are no runs");
  EXPECT_ERROR(joint_outcomes({{true}, {}}), "a run has 0 items, the first has 1");
}

}  // namespace
}  // namespace gurney::statistics
