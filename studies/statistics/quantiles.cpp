#include "studies/statistics/quantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "studies/statistics/special.h"

namespace gurney::statistics {

double quantile_of(std::vector<double> sample, double probability) {
  const double place = probability * static_cast<double>(sample.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(std::floor(place));
  std::nth_element(sample.begin(), sample.begin() + below, sample.end());
  const double low = sample[static_cast<std::size_t>(below)];
  const double part = place - static_cast<double>(below);
  if (part == 0) return low;
  const double high = *std::min_element(sample.begin() + below + 1, sample.end());
  return low == high ? low : low + part * (high - low);
}

Moments moments_of(const std::vector<double>& sample) {
  const double n = static_cast<double>(sample.size());
  Moments moments;
  if (sample.empty()) return moments;
  moments.mean = std::accumulate(sample.begin(), sample.end(), 0.0) / n;
  if (sample.size() < 2) return moments;
  for (const double x : sample) moments.variance += std::pow(x - moments.mean, 2) / (n - 1);
  return moments;
}

std::vector<double> ranks_of(const std::vector<double>& sample) {
  std::vector<std::size_t> order(sample.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sample[a] < sample[b]; });
  std::vector<double> ranks(sample.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    while (end < order.size() && sample[order[end]] == sample[order[i]]) ++end;
    const double rank = static_cast<double>(i + 1 + end) / 2;
    for (; i < end; ++i) ranks[order[i]] = rank;
  }
  return ranks;
}

MedianInterval median_interval(std::vector<double> sample, double confidence) {
  std::ranges::sort(sample);
  const int n = static_cast<int>(sample.size());
  int k = 0;  // the interval is from the k-th smallest to the k-th largest value; 0: unbounded
  while (2 * (k + 1) <= n && 2 * binomial_cdf(k, n, 0.5) <= 1 - confidence) ++k;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (k == 0) return {quantile_of(sample, 0.5), {-kInfinity, kInfinity}};
  const auto at = static_cast<std::size_t>(k - 1);
  return {quantile_of(sample, 0.5), {sample[at], sample[sample.size() - 1 - at]}};
}

}  // namespace gurney::statistics
