#pragma once

#include <vector>

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

}  // namespace gurney::statistics
