#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>

namespace gurney::statistics {

/// A function at one point: its value, gradient and negative Hessian; value = -inf outside its
/// domain, where the rest is not read.
template <int kSize>
struct Quadratic {
  double value;
  Eigen::Matrix<double, kSize, 1> gradient;
  Eigen::Matrix<double, kSize, kSize> curvature;
};

template <int kSize>
struct Maximum {
  bool found = false;
  Eigen::Matrix<double, kSize, 1> point;
  Quadratic<kSize> at;  ///< the function at `point`
};

/// Newton's method with step halving for a concave function: each step raises the value (Boyd &
/// Vandenberghe 2004, section 9.5, with their sufficient increase 1e-4). Such a function has one
/// maximum or none; `found` is false where it has none or where its curvature is singular there.
///
/// @param function  point -> Quadratic
/// @param start     where the value is finite
template <int kSize, typename Function>
Maximum<kSize> maximize(const Function& function, Eigen::Matrix<double, kSize, 1> start) {
  constexpr int kMaxSteps = 100;
  constexpr double kClose = 1e-13;  // expected gain of a step, in units of ln likelihood
  Maximum<kSize> best{false, start, function(start)};
  for (int step = 0; step < kMaxSteps; ++step) {
    const Eigen::LDLT<Eigen::Matrix<double, kSize, kSize>> factor(best.at.curvature);
    const Eigen::Matrix<double, kSize, 1> direction = factor.solve(best.at.gradient);
    const double gain = best.at.gradient.dot(direction);
    if (!(factor.rcond() > 1e-14) || !factor.isPositive() || !std::isfinite(gain)) return best;
    double length = 1;
    Maximum<kSize> next{false, best.point + direction, {}};
    next.at = function(next.point);
    if (gain < kClose * (1 + std::abs(best.at.value))) {
      if (std::isfinite(next.at.value)) best = next;  // the value is flat to rounding here
      best.found = true;
      return best;
    }
    while (!(next.at.value >= best.at.value + 1e-4 * length * gain)) {
      length /= 2;
      if (length < 1e-12) return best;
      next.point = best.point + length * direction;
      next.at = function(next.point);
    }
    best = next;
  }
  return best;
}

}  // namespace gurney::statistics
