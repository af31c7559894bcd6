#include "studies/statistics/capacity_intervals.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "engine/base/random/normal_draw.h"
#include "studies/statistics/censored_normal.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFarthest = 1e3;  // of an end, in standard errors
constexpr int kHalvings = 30;
using Direction = Eigen::Vector2d;

/// The likelihood in m = mu / sigma and h = 1 / sigma, mu = ln theta and sigma = beta.
class Likelihood {
 public:
  Likelihood(const std::vector<Capacity>& capacities, const CapacityFit& fit)
      : values_(log_capacities(capacities)),
        design_(Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(values_.size()), 1)),
        best_(std::log(fit.curve->theta) / fit.curve->beta, 1 / fit.curve->beta),
        highest_(fit.log_likelihood) {}

  const Eigen::Vector2d& best() const { return best_; }

  /// Twice the ln of the likelihood ratio of the best against the best on `point` + c `along`.
  double drop(const Eigen::Vector2d& point, const Direction& along) const {
    const auto function = [&](const Eigen::Matrix<double, 1, 1>& c) {
      const auto full = censored_normal_likelihood(design_, values_, point + c[0] * along);
      Quadratic<1> restricted{full.value, {}, {}};
      restricted.gradient[0] = full.gradient.dot(along);
      restricted.curvature(0, 0) = along.dot(full.curvature * along);
      return restricted;
    };
    const double start = along.dot(best_ - point) / along.squaredNorm();
    return 2 * (highest_ - maximize<1>(function, Eigen::Matrix<double, 1, 1>(start)).at.value);
  }

  /// With the score h ln im - m held.
  double drop_of_score(double log_im, double score) const { return drop({-score, 0}, {log_im, 1}); }
  /// With both held: slope h and intercept -m.
  double drop_of_line(const Eigen::Vector2d& line) const {
    const Eigen::Vector2d point(-line[1], line[0]);
    return 2 * (highest_ - censored_normal_likelihood(design_, values_, point).value);
  }
  double drop_of_beta(double beta) const { return drop({best_[0], 1 / beta}, {1, 0}); }

 private:
  std::vector<CensoredValue> values_;
  Eigen::MatrixXd design_;
  Eigen::Vector2d best_;
  double highest_;
};

/// The distance from 0, in the direction of `step`, at which `drop` rises through `limit`.
double crossing(const std::function<double(double)>& drop, double limit, double step) {
  double inside = 0, outside = step;
  while (!(drop(outside) > limit)) {
    inside = outside;
    outside *= 2;
    if (std::abs(outside) > kFarthest * std::abs(step)) return std::copysign(kInfinity, step);
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (inside + outside) / 2;
    (drop(middle) > limit ? outside : inside) = middle;
  }
  return (inside + outside) / 2;
}

/// The likelihood ratios of n exact capacities at the ends of their exact intervals.
struct Limits {
  double mean, beta_low, beta_high;
};

Limits limits_of_exact(double n, double confidence) {
  const double t = student_quantile((1 + confidence) / 2, n - 1);
  const auto of_beta = [&](double probability) {
    const double w = chi_squared_quantile(probability, n - 1);
    return w - n - n * std::log(w / n);
  };
  return {n * std::log1p(t * t / (n - 1)), of_beta((1 + confidence) / 2),
          of_beta((1 - confidence) / 2)};
}

/// The lines on which the likelihood ratio is at `limit`, in the directions of an ellipse around
/// the best one.
std::vector<Eigen::Vector2d> outline_of(const Likelihood& likelihood, const CapacityFit& fit,
                                        double limit) {
  const Eigen::Vector2d line(likelihood.best()[1], -likelihood.best()[0]);
  Eigen::Matrix2d jacobian;  // of slope and intercept to ln theta and ln beta
  jacobian << 0, -line[0], -line[0], -line[1];
  const Eigen::Matrix2d covariance = jacobian * fit.covariance * jacobian.transpose();
  std::vector<Eigen::Vector2d> outline;
  for (const Eigen::Vector2d& point : statistics::outline_of(line, covariance, 1)) {
    const double length = crossing(
        [&](double d) { return likelihood.drop_of_line(line + d * (point - line)); }, limit, 1);
    if (std::isfinite(length)) outline.push_back(line + length * (point - line));
  }
  return outline;
}

}  // namespace

double effective_capacities(const std::vector<Capacity>& capacities, const CapacityFit& fit) {
  double records = 0;
  for (const Capacity& each : capacities) records += each.weight;
  return std::clamp(0.5 / fit.covariance(1, 1), 2.0, std::max(2.0, records));
}

CapacityIntervals capacity_intervals(const std::vector<Capacity>& capacities,
                                     const CapacityFit& fit, const std::vector<double>& im,
                                     double confidence) {
  const Likelihood likelihood(capacities, fit);
  const double theta = fit.curve->theta, beta = fit.curve->beta;
  const double n = effective_capacities(capacities, fit);
  const Limits limits = limits_of_exact(n, confidence);
  const auto of_theta = [&](double d) { return likelihood.drop_of_score(std::log(theta) + d, 0); };
  const auto of_beta = [&](double d) { return likelihood.drop_of_beta(beta * std::exp(d)); };
  const double step = std::sqrt(fit.covariance(0, 0)), step_of_beta = std::sqrt(0.5 / n);
  CapacityIntervals intervals;
  intervals.theta = {theta * std::exp(crossing(of_theta, limits.mean, -step)),
                     theta * std::exp(crossing(of_theta, limits.mean, step))};
  intervals.beta = {beta * std::exp(crossing(of_beta, limits.beta_low, -step_of_beta)),
                    beta * std::exp(crossing(of_beta, limits.beta_high, step_of_beta))};
  intervals.outline = outline_of(likelihood, fit, limits.mean);
  for (const double x : im) {
    const double score = std::log(x / theta) / beta;
    const auto of_score = [&](double d) {
      return likelihood.drop_of_score(std::log(x), score + d);
    };
    const double error = std::hypot(step / beta, score * step_of_beta);
    intervals.of_curve.push_back({normal_cdf(score + crossing(of_score, limits.mean, -error)),
                                  normal_cdf(score + crossing(of_score, limits.mean, error))});
  }
  return intervals;
}

}  // namespace gurney::statistics
