#include "studies/statistics/cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double logistic(double line) { return 1 / (1 + std::exp(-line)); }

}  // namespace

CensoredValue log_demand(const CloudPoint& point) {
  const double y = std::log(point.edp);
  switch (point.known) {
    case CloudPoint::Known::kAtLeast:
      return {y, kInfinity};
    case CloudPoint::Known::kAtMost:
      return {-kInfinity, y};
    default:
      return {y, y};
  }
}

std::string text(CloudStatus status) {
  switch (status) {
    case CloudStatus::kFitted:
      return "fitted";
    case CloudStatus::kTooFewExact:
      return "fewer than 3 demands are known exactly";
    case CloudStatus::kOneIntensity:
      return "all demands that are known exactly are at one intensity, so there is no slope";
    case CloudStatus::kNoSpread:
      return "the demands lie on a line, so sigma is not determined";
  }
  return {};
}

CloudFit fit_cloud(const std::vector<CloudPoint>& points) {
  CloudFit fit;
  fit.covariance.setZero();
  fit.cluster_covariance.setZero();
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd design(n, 2);
  std::vector<CensoredValue> values;
  std::vector<std::size_t> groups;
  double lowest = kInfinity, highest = 0;  // im of exact demands
  for (const CloudPoint& point : points) {
    require(point.im > 0 && std::isfinite(point.im),
            fmt::format("im = {:g} must be > 0", point.im));
    require(point.edp > 0 && std::isfinite(point.edp),
            fmt::format("edp = {:g} must be > 0", point.edp));
    design.row(static_cast<Eigen::Index>(values.size())) << 1, std::log(point.im);
    values.push_back(log_demand(point));
    groups.push_back(point.group);
    fit.at_least += point.known == CloudPoint::Known::kAtLeast;
    fit.at_most += point.known == CloudPoint::Known::kAtMost;
    if (point.known != CloudPoint::Known::kExactly) continue;
    ++fit.exact;
    lowest = std::min(lowest, point.im);
    highest = std::max(highest, point.im);
  }
  if (fit.exact < 3) return fit;
  fit.status = CloudStatus::kOneIntensity;
  if (!(lowest < highest)) return fit;
  const CensoredNormalFit normal = fit_censored_normal(design, values, groups);
  fit.status = normal.found ? CloudStatus::kFitted : CloudStatus::kNoSpread;
  if (!normal.found) return fit;
  fit.a = normal.coefficients[0];
  fit.b = normal.coefficients[1];
  const double count = static_cast<double>(n);
  fit.sigma = normal.sigma * std::sqrt(count / (count - 2));
  fit.covariance = normal.covariance * (count / (count - 2));
  fit.cluster_covariance = normal.cluster_covariance;
  fit.log_likelihood = normal.log_likelihood;
  const CensoredNormalFit flat = fit_censored_normal(Eigen::MatrixXd::Ones(n, 1), values, groups);
  if (flat.found) fit.r_squared = std::max(0.0, 1 - std::pow(normal.sigma / flat.sigma, 2));
  return fit;
}

std::optional<CloudFragility> cloud_fragility(const CloudFit& fit, double limit) {
  require(limit > 0, fmt::format("limit = {:g} must be > 0", limit));
  if (fit.status != CloudStatus::kFitted || !(fit.b > 0)) return {};
  const double log_theta = (std::log(limit) - fit.a) / fit.b;
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << -1 / fit.b, -log_theta / fit.b, 0, 0, -1 / fit.b, 1;
  return CloudFragility{{std::exp(log_theta), fit.sigma / fit.b},
                        jacobian * fit.cluster_covariance * jacobian.transpose()};
}

double TwoPartCloud::collapse_probability(double im) const {
  return collapse.status == FragilityStatus::kNoneExceeds ? 0 : logistic(collapse.score(im));
}

double TwoPartCloud::probability(double limit, double im) const {
  const double collapsed = collapse_probability(im);
  const double score = (without.a + without.b * std::log(im) - std::log(limit)) / without.sigma;
  return collapsed + (1 - collapsed) * normal_cdf(score);
}

TwoPartCloud fit_two_part_cloud(const std::vector<CloudPoint>& points,
                                const std::vector<bool>& collapsed) {
  require(points.size() == collapsed.size(),
          fmt::format("{} points have {} outcomes: must be one for each", points.size(),
                      collapsed.size()));
  std::vector<CloudPoint> standing;
  std::vector<Observation> outcomes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    outcomes.push_back({points[i].im, collapsed[i], points[i].group});
    if (!collapsed[i]) standing.push_back(points[i]);
  }
  TwoPartCloud cloud;
  cloud.without = fit_cloud(standing);
  cloud.collapse = fit_logistic(StripeTable(outcomes).stripes());
  cloud.fitted =
      cloud.without.status == CloudStatus::kFitted &&
      (cloud.collapse.has_line() || cloud.collapse.status == FragilityStatus::kNoneExceeds);
  return cloud;
}

ProbitFit fit_logistic(const std::vector<Stripe>& stripes) {
  return fit_line(stripes, [&](const Eigen::Vector2d& line) {
    Quadratic<2> sum{0, Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero()};
    for (const Stripe& stripe : stripes) {
      const Eigen::Vector2d x(std::log(stripe.im), 1);
      const double z = line.dot(x), p = logistic(z);
      // ln p and ln(1 - p) without overflow
      const double softplus = std::max(z, 0.0) + std::log1p(std::exp(-std::abs(z)));
      sum.value += stripe.exceeded * (z - softplus) - (stripe.runs - stripe.exceeded) * softplus;
      sum.gradient += (stripe.exceeded - stripe.runs * p) * x;
      sum.curvature += stripe.runs * p * (1 - p) * x * x.transpose();
    }
    return sum;
  });
}

}  // namespace gurney::statistics
