#include "studies/statistics/median_interval.h"

#include <algorithm>
#include <limits>

#include "studies/statistics/quantiles.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {

MedianInterval median_interval(std::vector<double> sample, double confidence) {
  std::ranges::sort(sample);
  const int n = static_cast<int>(sample.size());
  int k = 0;  // how many values on either side are outside
  while (2 * (k + 1) <= n && 2 * binomial_cdf(k, n, 0.5) <= 1 - confidence) ++k;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (k == 0) return {quantile_of(sample, 0.5), {-kInfinity, kInfinity}};
  const auto at = static_cast<std::size_t>(k - 1);
  return {quantile_of(sample, 0.5), {sample[at], sample[sample.size() - 1 - at]}};
}

}  // namespace gurney::statistics
