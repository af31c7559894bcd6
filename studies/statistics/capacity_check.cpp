#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/random/normal_draw.h"
#include "studies/statistics/capacity_intervals.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The largest distance of the curve from what the brackets leave open of the empirical
/// distribution, at their ends.
double distance(const std::vector<Capacity>& capacities, const LognormalCurve& curve) {
  std::vector<double> lows, highs;
  for (const Capacity& each : capacities) {
    lows.push_back(each.low);
    highs.push_back(each.high);
  }
  std::ranges::sort(lows);
  std::ranges::sort(highs);
  const auto n = static_cast<double>(capacities.size());
  double largest = 0;
  for (const auto* ends : {&lows, &highs})
    for (const double end : *ends) {
      if (!std::isfinite(end)) continue;
      const auto below = std::ranges::upper_bound(highs, end) - highs.begin();
      const auto begun = std::ranges::lower_bound(lows, end) - lows.begin();
      const double p = curve.probability(end);
      largest = std::max(
          {largest, static_cast<double>(below) / n - p, p - static_cast<double>(begun) / n});
    }
  return largest;
}

/// Capacities of the curve in brackets as wide as those seen, censored where the first one was.
std::vector<Capacity> drawn(const std::vector<Capacity>& seen, const LognormalCurve& curve,
                            std::uint64_t seed, std::uint64_t resample) {
  double censored_at = kInfinity, width = 0;
  for (const Capacity& each : seen)
    if (each.high == kInfinity) censored_at = std::min(censored_at, each.low);
  std::vector<Capacity> all;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].high < kInfinity) width = std::log(seen[i].high / seen[i].low);
    const double capacity = curve.quantile(uniform_draw(seed, resample, 2 * i));
    const double place = uniform_draw(seed, resample, 2 * i + 1);
    if (capacity > censored_at)
      all.push_back({i, censored_at, kInfinity});
    else
      all.push_back(
          {i, capacity * std::exp(-place * width), capacity * std::exp((1 - place) * width)});
  }
  return all;
}

}  // namespace

std::optional<double> p_of_lognormal(const std::vector<Capacity>& capacities,
                                     const CapacityFit& fit, int resamples, std::uint64_t seed) {
  if (std::ranges::any_of(capacities, [](const Capacity& each) {
        return each.low == 0 || each.weight != 1;  // a record with several cases has no law here
      }))
    return {};
  const double seen = distance(capacities, *fit.curve);
  int as_far = 0, fitted = 0;
  for (int i = 0; i < resamples; ++i) {
    const auto resample = drawn(capacities, *fit.curve, seed, static_cast<std::uint64_t>(i));
    const CapacityFit again = fit_capacities(resample);
    if (!again.curve) continue;
    ++fitted;
    if (distance(resample, *again.curve) >= seen) ++as_far;
  }
  return (1.0 + as_far) / (1.0 + fitted);
}

}  // namespace gurney::statistics
