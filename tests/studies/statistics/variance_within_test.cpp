#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/random/normal_draw.h"
#include "studies/statistics/sensitivity.h"

namespace gurney::statistics {
namespace {

// By hand: classes {1, 3}, {5, 7}, {9, 11}: MS_within = 6 / 3 = 2, MS_between = 64 / 2 = 32, n_0 = 2,
// variance between (32 - 2) / 2 = 15.
TEST(ShareWithinClasses, IsThatOfTheAnalysisOfVariance) {
  const auto share = share_within_classes({0, 0, 1, 1, 2, 2}, {1, 3, 5, 7, 9, 11});
  ASSERT_TRUE(share);
  EXPECT_NEAR(share->estimate, 2.0 / 17, 1e-15);
}

// Classes of 2, 4 and 6 values, of variance 1 about means of variance 3: a quarter. Both components
// are unbiased, their ratio nearly, with 400 * 3 classes: the error of the variance between is
// sqrt(2 / 1200) 3.3 (with that of the means), 4 %, so that of the share 0.25 * 0.75 * 0.05 = 0.009
// (within 2 %); times 4.5.
TEST(ShareWithinClasses, FindsAKnownShareInClassesOfUnequalSizes) {
  std::vector<std::size_t> classes;
  std::vector<double> y;
  for (std::size_t c = 0; c < 1200; ++c)
    for (std::size_t i = 0; i < 2 + 2 * (c % 3); ++i) {
      classes.push_back(c);
      y.push_back(std::sqrt(3.0) * normal_draw(1, c, 0) + normal_draw(1, c, i + 1));
    }
  const auto share = share_within_classes(classes, y);
  ASSERT_TRUE(share);
  EXPECT_NEAR(share->estimate, 0.25, 0.041);
  EXPECT_TRUE(share->interval.contains(0.25));
}

// 300 repetitions of 30 classes of five, share one half: 285 expected, 4.5 standard deviations of
// 3.8 below; percentiles of 30 are known to be too narrow by a few percent (Davison & Hinkley 1997,
// section 5.4), for which 15 more are allowed.
TEST(ShareWithinClasses, IntervalContainsTheTruth) {
  int covered = 0;
  for (std::uint64_t repeat = 0; repeat < 300; ++repeat) {
    std::vector<std::size_t> classes;
    std::vector<double> y;
    for (std::size_t c = 0; c < 30; ++c)
      for (std::size_t i = 0; i < 5; ++i) {
        classes.push_back(c);
        y.push_back(normal_draw(repeat, c, 0) + normal_draw(repeat, c, i + 1));
      }
    const auto share = share_within_classes(classes, y, {.resamples = 199});
    covered += share && share->interval.contains(0.5);
  }
  EXPECT_GE(covered, 253);
}

TEST(ShareWithinClasses, NeedsClassesOfTwoAndVariation) {
  EXPECT_FALSE(share_within_classes({0, 1, 2}, {1, 2, 3}));
  EXPECT_FALSE(share_within_classes({0, 0, 0}, {1, 2, 3}));
  EXPECT_FALSE(share_within_classes({0, 0, 1, 1}, {1, 1, 1, 1}));
}

}  // namespace
}  // namespace gurney::statistics
