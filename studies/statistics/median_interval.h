#pragma once

#include <vector>

#include "studies/statistics/bands.h"

namespace gurney::statistics {

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
