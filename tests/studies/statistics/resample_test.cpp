#include "studies/statistics/resample.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "studies/statistics/special.h"

namespace gurney::statistics {
namespace {

TEST(ResampledTimes, DrawsAsManyGroupsAsThereAreAndDependsOnItsArgumentsAlone) {
  for (std::uint64_t sample = 0; sample < 50; ++sample) {
    const std::vector<int> times = resampled_times(12, 3, sample);
    EXPECT_EQ(std::accumulate(times.begin(), times.end(), 0), 12);
    EXPECT_EQ(times, resampled_times(12, 3, sample));
  }
  EXPECT_NE(resampled_times(12, 3, 0), resampled_times(12, 3, 1));
  EXPECT_NE(resampled_times(12, 3, 0), resampled_times(12, 4, 0));
}

TEST(BootstrapInterval, OfAMeanIsThatOfTheNormalLimitAndNotOfTheThreads) {
  // Values 0 and 1 in turn: the bootstrap distribution of the mean of 400 is binomial(400, 1/2) / 400
  // with s = 0.025. A percentile of 4000 samples is off by sqrt(p (1 - p) / 4000) / density, with p =
  // 0.025 by 0.0025 / (0.0584 / s) = 0.0011, and the steps are 1 / 400: 4 x 0.0011 + 0.0025.
  const auto mean = [](const std::vector<int>& times) {
    double sum = 0;
    for (std::size_t i = 0; i < times.size(); i += 2) sum += times[i];
    return sum / static_cast<double>(times.size());
  };
  const Interval found = bootstrap_interval(400, 1, 4000, 1, mean);
  EXPECT_NEAR(found.low, 0.5 - 1.96 * 0.025, 0.007);
  EXPECT_NEAR(found.high, 0.5 + 1.96 * 0.025, 0.007);
  const Interval threads = bootstrap_interval(400, 1, 4000, 3, mean);
  EXPECT_EQ(found.low, threads.low);
  EXPECT_EQ(found.high, threads.high);
}

TEST(GroupedProportion, OfGroupsOfOneRunIsCloppersAndPearsons) {
  std::vector<GroupOutcomes> groups(20, {1, 0});
  for (std::size_t i = 0; i < 6; ++i) groups[i].happened = 1;
  const Proportion found = grouped_proportion(groups);
  const Interval exact = proportion_interval(6, 20);
  EXPECT_DOUBLE_EQ(found.estimate, 0.3);
  EXPECT_NEAR(found.effective, 20 * 19.0 / 20, 1.01);  // (n - 1) / n in the variance; at most n
  EXPECT_NEAR(found.interval.low, exact.low, 1e-12);
  EXPECT_NEAR(found.interval.high, exact.high, 1e-12);
}

TEST(GroupedProportion, CountsGroupsWhereTheRunsOfAGroupAreAlike) {
  std::vector<GroupOutcomes> groups(20, {8, 0});
  for (std::size_t i = 0; i < 6; ++i) groups[i].happened = 8;
  const Proportion found = grouped_proportion(groups);
  const Interval exact = proportion_interval(6, 20);
  EXPECT_DOUBLE_EQ(found.estimate, 0.3);
  EXPECT_NEAR(found.interval.low, exact.low, 1e-12);
  EXPECT_NEAR(found.interval.high, exact.high, 1e-12);
}

TEST(GroupedProportion, OfNoneCountsTheGroups) {
  const Proportion found = grouped_proportion(std::vector<GroupOutcomes>(10, {4, 0}));
  EXPECT_EQ(found.interval.low, 0);
  EXPECT_NEAR(found.interval.high, 1 - std::pow(0.025, 1.0 / 10), 1e-12);
}

}  // namespace
}  // namespace gurney::statistics
