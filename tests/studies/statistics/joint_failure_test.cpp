#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/statistics/hazard.h"
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

}  // namespace
}  // namespace gurney::statistics
