#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>

namespace gurney::statistics {

/// Distribution functions for tests and intervals; the normal one is in engine/base/random.

double normal_density(double x);

/// ln Phi(x) without underflow, relative error below 1e-9 for every finite x: the asymptotic series
/// where x < -37 (Abramowitz & Stegun 1964, 26.2.12).
double log_normal_cdf(double x);

/// phi(x) / Phi(x), the slope of log_normal_cdf(); about -x far below zero.
double normal_hazard_below(double x);

/// ln(Phi(high) - Phi(low)) for low < high, from the tail that is exact; either may be infinite.
double log_normal_between(double low, double high);

/// P(X > x) of the chi-squared distribution, degrees > 0; 1 for x <= 0.
double chi_squared_survival(double x, double degrees);
double chi_squared_quantile(double probability, double degrees);

/// P(T > t) of Student's distribution, degrees > 0.
double student_survival(double t, double degrees);
double student_quantile(double probability, double degrees);

/// P(F > f) of Fisher's distribution; 1 for f <= 0.
double fisher_survival(double f, double degrees_above, double degrees_below);

/// P(K <= k) of n trials with the given probability of success; 0 for k < 0.
double binomial_cdf(int k, int n, double probability);

/// Quantile of the beta distribution; 0 where a = 0, 1 where b = 0.
double beta_quantile(double probability, double a, double b);

/// A fragility curve P(exceeded | im) = Phi(ln(im / theta) / beta): the lognormal distribution of a
/// capacity (Kennedy et al. 1980, Nuclear Engineering and Design 59(2), 315-338).
struct LognormalCurve {
  double theta = 1;  ///< median capacity, in the unit of im, > 0
  double beta = 1;   ///< standard deviation of ln capacity, > 0

  double probability(double im) const;        ///< 0 for im <= 0
  double quantile(double probability) const;  ///< the im at a probability in (0, 1)
  double mean() const;                        ///< of the capacity, theta exp(beta^2 / 2)
  double standard_deviation() const;          ///< mean sqrt(exp(beta^2) - 1)
};

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
