#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "studies/statistics/bands.h"
#include "studies/statistics/newton.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Direction = Eigen::Vector2d;

/// Largest likelihood on the line `point` + c `along` in (slope, intercept).
double best_on(const std::vector<Stripe>& stripes, const Eigen::Vector2d& point,
               const Direction& along) {
  const auto function = [&](const Eigen::Matrix<double, 1, 1>& c) {
    const Quadratic<2> full = binomial_likelihood(stripes, point + c[0] * along);
    Quadratic<1> restricted{full.value, {}, {}};
    restricted.gradient[0] = full.gradient.dot(along);
    restricted.curvature(0, 0) = along.dot(full.curvature * along);
    return restricted;
  };
  return maximize<1>(function, Eigen::Matrix<double, 1, 1>(0.0)).at.value;
}

/// The distance from 0, in the direction of `step`, at which `drop` rises through `limit`; infinite
/// if it has not within 1000 steps' length.
double crossing(const std::function<double(double)>& drop, double limit, double step) {
  double inside = 0, outside = step;
  while (!(drop(outside) > limit)) {
    inside = outside;
    outside *= 2;
    if (std::abs(outside) > 1000 * std::abs(step)) return std::copysign(kInfinity, step);
  }
  for (int i = 0; i < 50; ++i) {
    const double middle = (inside + outside) / 2;
    (drop(middle) > limit ? outside : inside) = middle;
  }
  return (inside + outside) / 2;
}

}  // namespace

std::optional<ProfileIntervals> profile_intervals(const StripeTable& table, double confidence,
                                                  bool by_group) {
  const std::vector<Stripe>& stripes = table.stripes();
  const ProbitFit fit = fit_probit(stripes);
  if (fit.status != FragilityStatus::kFitted || (by_group && table.groups() < 2)) return {};
  const Eigen::Matrix2d plain = covariance_of_curve(fit.line, fit.information.inverse());
  Eigen::Vector2d inflation(1, 1);
  double quantile = chi_squared_quantile(confidence, 1);
  if (by_group) {
    const Eigen::Matrix2d of_groups = cluster_covariance(fit, table);
    const auto grouped = covariance_of_curve(fit.line, of_groups);
    // The mean over both parameters varies less with few groups than that of one.
    const double mean = (of_groups * fit.information).trace() / 2;
    inflation = grouped.diagonal().cwiseQuotient(plain.diagonal()).cwiseMax(std::max(1.0, mean));
    const double degrees = std::max(1.0, effective_groups(fit, table) - 1);
    quantile = std::pow(student_quantile((1 + confidence) / 2, degrees), 2);
  }
  const double log_theta = std::log(fit.curve().theta);
  // theta fixed: slope (ln im - ln theta) with any slope; beta fixed: slope fixed, any intercept.
  const auto drop_theta = [&](double d) {
    const Direction along(1, -(log_theta + d));
    return 2 * (fit.log_likelihood - best_on(stripes, fit.line[0] * along, along));
  };
  const auto drop_beta = [&](double d) {
    const Eigen::Vector2d line = fit.line * std::exp(-d);
    return 2 * (fit.log_likelihood - best_on(stripes, line, Direction(0, 1)));
  };
  const auto interval = [&](const auto& drop, int parameter, double center) {
    const double limit = quantile * inflation[parameter];
    const double step = std::sqrt(plain(parameter, parameter) * inflation[parameter]);
    return Interval{center * std::exp(crossing(drop, limit, -step)),
                    center * std::exp(crossing(drop, limit, step))};
  };
  return ProfileIntervals{interval(drop_theta, 0, fit.curve().theta),
                          interval(drop_beta, 1, fit.curve().beta)};
}

}  // namespace gurney::statistics
