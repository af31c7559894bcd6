#include "studies/statistics/capacity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/base/error.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

FragilityStatus status_without_fit(double highest_low, double lowest_high) {
  if (lowest_high == kInfinity) return FragilityStatus::kNoneExceeds;
  if (highest_low == 0) return FragilityStatus::kAllExceed;
  return highest_low < lowest_high ? FragilityStatus::kSeparated : FragilityStatus::kQuasiSeparated;
}

/// Every bracket ends or begins at `im`: those below it, and the nearest ends on either side.
MedianBounds bounds_around(double im, const std::vector<Capacity>& capacities) {
  double all = 0, below = 0, nearest_low = 0, nearest_high = kInfinity;
  for (const Capacity& each : capacities) {
    all += each.weight;
    if (each.high <= im) {
      below += each.weight;
      nearest_low = std::max(nearest_low, each.low);
    } else {
      nearest_high = std::min(nearest_high, each.high);
    }
  }
  return median_bounds(im, below / all, nearest_low, nearest_high);
}

}  // namespace

std::vector<Capacity> ida_capacities(const std::vector<Observation>& observations) {
  using Case = std::pair<std::size_t, std::size_t>;  // of a group
  std::map<Case, std::vector<Observation>> of_case;
  std::map<std::size_t, int> cases;
  for (const Observation& seen : observations) {
    require(seen.im > 0 && std::isfinite(seen.im), fmt::format("im = {:g} must be > 0", seen.im));
    auto& runs = of_case[{seen.group, seen.analysis_case}];
    if (runs.empty()) ++cases[seen.group];
    runs.push_back(seen);
  }
  std::vector<Capacity> capacities;
  for (const auto& [place, runs] : of_case) {
    const std::size_t group = place.first;
    Capacity capacity{group, 0, kInfinity, 0, static_cast<int>(runs.size()), 1.0 / cases[group]};
    for (const Observation& run : runs)
      if (run.exceeded) capacity.high = std::min(capacity.high, run.im);
    for (const Observation& run : runs) {
      if (run.exceeded) continue;
      if (run.im < capacity.high)
        capacity.low = std::max(capacity.low, run.im);
      else
        ++capacity.resurrections;
    }
    capacities.push_back(capacity);
  }
  return capacities;
}

std::vector<CensoredValue> log_capacities(const std::vector<Capacity>& capacities) {
  std::vector<CensoredValue> values;
  for (const Capacity& capacity : capacities) {
    require(capacity.low >= 0 && capacity.low <= capacity.high && capacity.high > 0,
            fmt::format("a capacity within {:g} to {:g} is none", capacity.low, capacity.high));
    if (capacity.low > 0 || capacity.high < kInfinity)
      values.push_back({std::log(capacity.low), std::log(capacity.high), capacity.weight});
  }
  return values;
}

CapacityFit fit_capacities(const std::vector<Capacity>& capacities) {
  CapacityFit fit;
  if (capacities.empty()) return fit;
  const std::vector<CensoredValue> values = log_capacities(capacities);
  double highest_low = 0, lowest_high = kInfinity;
  for (const Capacity& capacity : capacities) {
    fit.censored += capacity.high == kInfinity ? 1 : 0;
    fit.resurrections += capacity.resurrections;
    highest_low = std::max(highest_low, capacity.low);
    lowest_high = std::min(lowest_high, capacity.high);
  }
  if (highest_low <= lowest_high) {
    fit.status = status_without_fit(highest_low, lowest_high);
    fit.low = highest_low;
    fit.high = lowest_high;
    fit.median = fit.status == FragilityStatus::kQuasiSeparated
                     ? bounds_around(highest_low, capacities)
                     : MedianBounds{highest_low, lowest_high};
    return fit;
  }
  const auto n = static_cast<Eigen::Index>(values.size());
  const CensoredNormalFit normal = fit_censored_normal(Eigen::MatrixXd::Ones(n, 1), values);
  fit.status = normal.found ? FragilityStatus::kFitted : FragilityStatus::kNotIncreasing;
  if (!normal.found) return fit;
  fit.curve = LognormalCurve{std::exp(normal.coefficients[0]), normal.sigma};
  fit.covariance = normal.covariance;
  fit.log_likelihood = normal.log_likelihood;
  return fit;
}

}  // namespace gurney::statistics
