#pragma once

#include <vector>

#include "studies/statistics/bands.h"

namespace gurney::statistics {

/// The quantile of a sample, linear between the order statistics: Hyndman & Fan (1996, American
/// Statistician 50(4), 361-365), type 7, as numpy and R. Infinite values are allowed.
/// @param probability  in [0, 1]
/// @pre not empty, no NaN
double quantile_of(std::vector<double> sample, double probability);

/// Mean, and variance with divisor n - 1 (0 for one value).
struct Moments {
  double mean = 0, variance = 0;
};
Moments moments_of(const std::vector<double>& sample);

/// Ranks 1 to n, ties at their mean.
std::vector<double> ranks_of(const std::vector<double>& sample);

/// The median of a sample and an interval of the population's that supposes no distribution:
/// between the k-th smallest and the k-th largest value, k as large as the binomial distribution
/// allows (Thompson 1936, Annals of Mathematical Statistics 7(3), 122-128). It is the sign test
/// turned round. All numbers where the sample is too small: under 6 for 95 %.
struct MedianInterval {
  double median = 0;
  Interval interval;
};

/// @pre not empty
MedianInterval median_interval(std::vector<double> sample, double confidence = 0.95);

}  // namespace gurney::statistics
