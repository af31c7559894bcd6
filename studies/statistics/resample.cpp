#include "studies/statistics/resample.h"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/base/random/normal_draw.h"
#include "studies/statistics/quantiles.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {

std::vector<int> resampled_times(std::size_t groups, std::uint64_t seed, std::uint64_t sample) {
  std::vector<int> times(groups, 0);
  for (std::size_t i = 0; i < groups; ++i)
    ++times[drawn_index(uniform_draw(seed, sample, i), groups)];
  return times;
}

Interval bootstrap_interval(std::size_t groups, std::uint64_t seed, int samples, int threads,
                            const std::function<double(const std::vector<int>&)>& statistic,
                            double confidence) {
  std::vector<double> values(static_cast<std::size_t>(samples));
  parallel_for(values.size(), threads,
               [&](std::size_t i) { values[i] = statistic(resampled_times(groups, seed, i)); });
  const double tail = (1 - confidence) / 2;
  return {quantile_of(values, tail), quantile_of(values, 1 - tail)};
}

Proportion grouped_proportion(const std::vector<GroupOutcomes>& groups, double confidence) {
  double runs = 0, happened = 0;
  for (const GroupOutcomes& each : groups) {
    runs += each.runs;
    happened += each.happened;
  }
  const double p = happened / runs, count = static_cast<double>(groups.size());
  double squares = 0;
  for (const GroupOutcomes& each : groups) squares += std::pow(each.happened - p * each.runs, 2);
  const double variance = count > 1 ? count / (count - 1) * squares / (runs * runs) : 0;
  const double effective =
      variance > 0 ? std::clamp(p * (1 - p) / variance, std::min(count, runs), runs) : count;
  const double tail = (1 - confidence) / 2, k = p * effective;
  return {
      p,
      {beta_quantile(tail, k, effective - k + 1), beta_quantile(1 - tail, k + 1, effective - k)},
      effective};
}

}  // namespace gurney::statistics
