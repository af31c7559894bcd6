#include "studies/statistics/cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/base/error.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

double effective_groups(const std::vector<CloudPoint>& points) {
  std::map<std::size_t, double> runs;
  for (const CloudPoint& point : points) runs[point.group] += 1;
  double squares = 0;
  for (const auto& [group, count] : runs)
    squares += std::pow(count / static_cast<double>(points.size()), 2);
  return 1 / squares;
}

FragilityBand cloud_band(const CloudFit& fit, const std::vector<CloudPoint>& points, double limit,
                         const std::vector<double>& im, double confidence) {
  const Eigen::Vector2d line(fit.b / fit.sigma, (fit.a - std::log(limit)) / fit.sigma);
  Eigen::Matrix<double, 2, 3> jacobian;  // of (slope, intercept) to (a, b, ln sigma)
  jacobian << 0, 1 / fit.sigma, -line[0], 1 / fit.sigma, 0, -line[1];
  const auto [low, high] = std::ranges::minmax(points, {}, &CloudPoint::im);
  const double effective = effective_groups(points);
  // The degrees that coefficients and sigma cost, of as many groups
  const double lost = effective > 3 ? effective / (effective - 3) : 1;
  return band_of({line,
                  {jacobian * fit.covariance * jacobian.transpose(),
                   lost * jacobian * fit.cluster_covariance * jacobian.transpose()},
                  effective,
                  low.im,
                  high.im},
                 im, confidence);
}

}  // namespace gurney::statistics
