#include "studies/statistics/profile.h"

#include <cmath>
#include <limits>

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
  constexpr double kFarthest = 1000;  // steps
  constexpr int kHalvings = 30;       // 1e-9 of the bracket
  double inside = 0, outside = step;
  while (!(drop(outside) > limit)) {
    inside = outside;
    outside *= 2;
    if (std::abs(outside) > kFarthest * std::abs(step))
      return std::copysign(std::numeric_limits<double>::infinity(), step);
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (inside + outside) / 2;
    (drop(middle) > limit ? outside : inside) = middle;
  }
  return (inside + outside) / 2;
}

}  // namespace gurney::statistics
