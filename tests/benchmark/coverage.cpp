#include "tests/benchmark/coverage.h"

#include <algorithm>
#include <cmath>

#include "studies/statistics/bands.h"

namespace gurney::benchmark {
namespace {

double log_choose(int n, int k) {
  return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
}

}  // namespace

bool covers(int few, int many) {
  return statistics::proportion_interval(few, kReplicas)
      .contains(static_cast<double>(many) / kMore);
}

double probability_of_cover(int total) {
  double sum = 0;
  for (int few = std::max(0, total - kMore); few <= std::min(total, kReplicas); ++few)
    if (covers(few, total - few))
      sum += std::exp(log_choose(kReplicas, few) + log_choose(kMore, total - few) -
                      log_choose(kReplicas + kMore, total));
  return sum;
}

}  // namespace gurney::benchmark
