#include "groundmotions/scaling/lowest_ratio.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace gurney::groundmotions {

namespace {

constexpr double kSteeper = 2;  ///< than the steepest interval nearby
constexpr int kRounds = 24;     ///< halve an interval to 1e-7 of its length

using Points = std::map<double, double>;  ///< ratio by ln T

double steepness(Points::const_iterator at) {
  const auto next = std::next(at);
  return std::abs(next->second - at->second) / (next->first - at->first);
}

/// The middles of the intervals that may hold a ratio below `bound`: between two ratios a function
/// of the slope s goes down to their mean less s times half the interval.
std::vector<double> middles_below(const Points& points, double bound) {
  std::vector<double> middles;
  for (auto at = points.begin(); std::next(at) != points.end(); ++at) {
    const auto next = std::next(at);
    double slope = steepness(at);
    if (at != points.begin()) slope = std::max(slope, steepness(std::prev(at)));
    if (std::next(next) != points.end()) slope = std::max(slope, steepness(next));
    const double least =
        (at->second + next->second) / 2 - kSteeper * slope * (next->first - at->first) / 2;
    if (least < bound) middles.push_back((at->first + next->first) / 2);
  }
  return middles;
}

Points::const_iterator lowest_of(const Points& points) {
  return std::ranges::min_element(points, {}, [](const auto& point) { return point.second; });
}

}  // namespace

LowestRatio lowest_ratio(const Eigen::VectorXd& periods, const Eigen::VectorXd& ratios,
                         const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& ratios_at,
                         double tolerance) {
  Points points;
  for (Eigen::Index i = 0; i < periods.size(); ++i) points[std::log(periods[i])] = ratios[i];
  for (int round = 0; round < kRounds; ++round) {
    const auto middles = middles_below(points, lowest_of(points)->second * (1 - tolerance));
    if (middles.empty()) break;
    const Eigen::VectorXd at =
        Eigen::Map<const Eigen::ArrayXd>(middles.data(), std::ssize(middles)).exp();
    const Eigen::VectorXd found = ratios_at(at);
    for (Eigen::Index i = 0; i < at.size(); ++i)
      points[middles[static_cast<std::size_t>(i)]] = found[i];
  }
  const auto lowest = lowest_of(points);
  return {std::exp(lowest->first), lowest->second};
}

}  // namespace gurney::groundmotions
