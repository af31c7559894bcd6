#include "studies/statistics/profile.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace gurney::statistics {

double largest_on_line(const std::function<Quadratic<2>(const Eigen::Vector2d&)>& function,
                       const Eigen::Vector2d& point, const Eigen::Vector2d& along, double start) {
  using Vector1 = Eigen::Matrix<double, 1, 1>;
  const auto on_line = [&](const Vector1& c) {
    const Quadratic<2> full = function(point + c[0] * along);
    Quadratic<1> restricted{full.value, {}, {}};
    restricted.gradient[0] = full.gradient.dot(along);
    restricted.curvature(0, 0) = along.dot(full.curvature * along);
    return restricted;
  };
  return maximize<1>(on_line, Vector1(start)).at.value;
}

double crossing(const std::function<double(double)>& drop, double limit, double step) {
  constexpr int kPlaces = 10;           // tried: 1, 2, ... 512 steps away
  constexpr double kResolution = 1e-9;  // of the bracket
  constexpr double kHighest = 1e6;      // for drops that are infinite
  // The root of a likelihood ratio is nearly straight, and few secants find where it crosses.
  const double level = std::sqrt(limit);
  const auto above = [&](double d) {
    return std::min(std::sqrt(std::max(0.0, drop(d))), kHighest) - level;
  };
  double inside = 0, outside = step, of_inside = -level, of_outside = above(outside);
  for (int place = 1; !(of_outside > 0); ++place) {
    if (place == kPlaces) return std::copysign(std::numeric_limits<double>::infinity(), step);
    inside = outside;
    of_inside = of_outside;
    outside *= 2;
    of_outside = above(outside);
  }
  if (step < 0) {
    std::swap(inside, outside);
    std::swap(of_inside, of_outside);
  }
  const double resolution = kResolution * (outside - inside);
  std::uintmax_t tries = 130;  // four for each of 30 halvings, which the method is sure of
  const auto bracket = boost::math::tools::toms748_solve(
      above, inside, outside, of_inside, of_outside,
      [=](double low, double high) { return high - low <= resolution; }, tries);
  return std::midpoint(bracket.first, bracket.second);
}

}  // namespace gurney::statistics
