#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "studies/statistics/quantiles.h"

namespace gurney::statistics {
namespace {

std::vector<double> one_to(int n) {
  std::vector<double> sample(static_cast<std::size_t>(n));
  std::iota(sample.rbegin(), sample.rend(), 1);
  return sample;
}

TEST(MedianInterval, IsBetweenOrderStatistics) {
  // Below k of n heads with probability 1/2: P(K <= 0 | 6) = 0.016, P(K <= 5 | 20) = 0.0207 and
  // P(K <= 6 | 20) = 0.0577.
  const MedianInterval six = median_interval(one_to(6)), twenty = median_interval(one_to(20));
  EXPECT_EQ(six.median, 3.5);
  EXPECT_EQ(six.interval.low, 1);
  EXPECT_EQ(six.interval.high, 6);
  EXPECT_EQ(twenty.interval.low, 6);
  EXPECT_EQ(twenty.interval.high, 15);
}

TEST(MedianInterval, IsUnknownForFiveValues) {
  const MedianInterval five = median_interval(one_to(5));
  EXPECT_EQ(five.median, 3);
  EXPECT_TRUE(std::isinf(five.interval.low) && std::isinf(five.interval.high));
}

}  // namespace
}  // namespace gurney::statistics
