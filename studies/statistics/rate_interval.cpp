#include "studies/statistics/rate_interval.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/random/normal_draw.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double rate_of(const Eigen::Vector2d& line, const HazardCurve& hazard) {
  if (line[0] > 0) {
    const LognormalCurve curve{std::exp(-line[1] / line[0]), 1 / line[0]};
    // A slope so small that theta or the rate overflows is one of 0.
    const double rate = std::isnormal(curve.theta) ? mean_rate(curve, hazard).rate : kInfinity;
    if (std::isfinite(rate)) return rate;
  }
  if (hazard.pieces().front().low == 0) return kInfinity;
  return mean_rate([&](double im) { return normal_cdf(line[0] * std::log(im) + line[1]); }, hazard)
      .rate;
}

}  // namespace

Interval rate_interval(const std::vector<Eigen::Vector2d>& outline, const HazardCurve& hazard) {
  if (outline.empty()) return {0, kInfinity};
  Interval interval{kInfinity, 0};
  for (const Eigen::Vector2d& line : outline) {
    const double rate = rate_of(line, hazard);
    interval = {std::min(interval.low, rate), std::max(interval.high, rate)};
  }
  return interval;
}

}  // namespace gurney::statistics
