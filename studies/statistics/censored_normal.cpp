#include "studies/statistics/censored_normal.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "engine/base/error.h"
#include "engine/base/linear_algebra.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNarrow = 1e-2;  // interval, in sigma, below which a series is more exact
using Dynamic = Quadratic<Eigen::Dynamic>;

/// A term of the likelihood as a function of m = x'g and h = 1 / sigma: value, first and second
/// derivatives.
struct Term {
  double value, m, h, mm, mh, hh;
};

Term exact_term(double y, double m, double h) {
  const double z = h * y - m;
  return {std::log(h) - z * z / 2 - std::log(2 * std::numbers::pi) / 2,
          z,
          1 / h - z * y,
          -1,
          y,
          -1 / (h * h) - y * y};
}

/// ln D = ln phi(c) + ln d + d^2 (c^2 - 1) / 24 + O(d^4), c the middle and d the width of (v, u).
Term narrow_term(const CensoredValue& y, double m, double h) {
  const double middle = (y.low + y.high) / 2, width = y.high - y.low;
  const double c = h * middle - m, d = h * width;
  const double of_c = -c + d * d * c / 12, of_d = 1 / d + d * (c * c - 1) / 12;
  const double cc = -1 + d * d / 12, cd = d * c / 6, dd = -1 / (d * d) + (c * c - 1) / 12;
  return {-c * c / 2 - std::log(2 * std::numbers::pi) / 2 + std::log(d) + d * d * (c * c - 1) / 24,
          -of_c,
          of_c * middle + of_d * width,
          cc,
          -(cc * middle + cd * width),
          cc * middle * middle + 2 * cd * middle * width + dd * width * width};
}

Term interval_term(const CensoredValue& y, double m, double h) {
  const bool has_low = std::isfinite(y.low), has_high = std::isfinite(y.high);
  const double u = has_high ? h * y.high - m : kInfinity, v = has_low ? h * y.low - m : -kInfinity;
  const double value = log_normal_between(v, u);
  const auto relative_density = [&](double x) {
    return std::exp(-x * x / 2 - std::log(2 * std::numbers::pi) / 2 - value);
  };
  const double a = has_high ? relative_density(u) : 0, b = has_low ? relative_density(v) : 0;
  const double high = has_high ? y.high : 0, low = has_low ? y.low : 0;
  const double uu = (has_high ? -u * a : 0) - a * a, vv = (has_low ? v * b : 0) - b * b;
  const double uv = a * b;
  return {value,
          -(a - b),
          a * high - b * low,
          uu + 2 * uv + vv,
          -(uu * high + uv * (high + low) + vv * low),
          uu * high * high + 2 * uv * high * low + vv * low * low};
}

Term unweighted_term(const CensoredValue& y, double m, double h) {
  if (y.exact()) return exact_term(y.low, m, h);
  if (std::isfinite(y.low) && std::isfinite(y.high) && h * (y.high - y.low) < kNarrow)
    return narrow_term(y, m, h);
  return interval_term(y, m, h);
}

Term term_of(const CensoredValue& y, double m, double h) {
  const Term one = unweighted_term(y, m, h);
  const double w = y.weight;
  return {w * one.value, w * one.m, w * one.h, w * one.mm, w * one.mh, w * one.hh};
}

Dynamic likelihood(const Eigen::MatrixXd& design, const std::vector<CensoredValue>& values,
                   bool positive, const Eigen::VectorXd& point) {
  const Eigen::Index p = design.cols();
  const double h = point[p];
  Dynamic sum{0, Eigen::VectorXd::Zero(p + 1), Eigen::MatrixXd::Zero(p + 1, p + 1)};
  if (positive && !(h > 0)) return {-kInfinity, sum.gradient, sum.curvature};
  const Eigen::VectorXd m = design * point.head(p);
  Eigen::VectorXd of_m(m.size()), of_mm(m.size()), of_mh(m.size());
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    const Term term = term_of(values[static_cast<std::size_t>(i)], m[i], h);
    of_m[i] = term.m;
    of_mm[i] = term.mm;
    of_mh[i] = term.mh;
    sum.value += term.value;
    sum.gradient[p] += term.h;
    sum.curvature(p, p) -= term.hh;
  }
  sum.gradient.head(p) = design.transpose() * of_m;
  sum.curvature.topLeftCorner(p, p) = -design.transpose() * of_mm.asDiagonal() * design;
  sum.curvature.topRightCorner(p, 1) = -design.transpose() * of_mh;
  sum.curvature.bottomLeftCorner(1, p) = sum.curvature.topRightCorner(p, 1).transpose();
  if (!std::isfinite(sum.value)) sum.value = -kInfinity;
  return sum;
}

/// A number for each row to begin with: its value, or the end that is known.
Eigen::VectorXd rough_values(const std::vector<CensoredValue>& values) {
  Eigen::VectorXd rough(static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const CensoredValue& y = values[i];
    rough[static_cast<Eigen::Index>(i)] = !std::isfinite(y.low)    ? y.high
                                          : !std::isfinite(y.high) ? y.low
                                                                   : (y.low + y.high) / 2;
  }
  return rough;
}

Eigen::MatrixXd spread_of_scores(const Eigen::MatrixXd& design,
                                 const std::vector<CensoredValue>& values,
                                 const std::vector<std::size_t>& groups,
                                 const Eigen::VectorXd& point) {
  const Eigen::Index p = design.cols();
  std::map<std::size_t, Eigen::VectorXd> scores;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Eigen::VectorXd x = design.row(static_cast<Eigen::Index>(i)).transpose();
    const Term term = term_of(values[i], x.dot(point.head(p)), point[p]);
    auto& score = scores.try_emplace(groups.empty() ? i : groups[i], Eigen::VectorXd::Zero(p + 1))
                      .first->second;
    score.head(p) += term.m * x;
    score[p] += term.h;
  }
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(p + 1, p + 1);
  if (scores.size() < 2) return spread;
  for (const auto& [group, score] : scores) spread += score * score.transpose();
  const double n = static_cast<double>(scores.size());
  return n / (n - 1) * spread;
}

/// Only rows with both ends somewhere know the sign of 1 / sigma.
bool has_bounded_row(const std::vector<CensoredValue>& values) {
  return std::ranges::any_of(
      values, [](const CensoredValue& y) { return std::isfinite(y.low) && std::isfinite(y.high); });
}

}  // namespace

Quadratic<Eigen::Dynamic> censored_normal_likelihood(const Eigen::MatrixXd& design,
                                                     const std::vector<CensoredValue>& values,
                                                     const Eigen::VectorXd& point) {
  return likelihood(design, values, has_bounded_row(values), point);
}

CensoredNormalFit fit_censored_normal(const Eigen::MatrixXd& design,
                                      const std::vector<CensoredValue>& values,
                                      const std::vector<std::size_t>& groups) {
  const Eigen::Index p = design.cols();
  require(design.rows() == static_cast<Eigen::Index>(values.size()) &&
              (groups.empty() || groups.size() == values.size()),
          fmt::format("{} values have {} rows and {} groups: must be one for each", values.size(),
                      design.rows(), groups.size()));
  for (const CensoredValue& y : values)
    if (!(y.low <= y.high && (std::isfinite(y.low) || std::isfinite(y.high))))
      throw Error(fmt::format("a value within {:g} to {:g} is none", y.low, y.high));
  const bool positive = has_bounded_row(values);
  CensoredNormalFit fit;
  if (design.rows() <= p) return fit;
  const Eigen::VectorXd rough = rough_values(values);
  if (rank(design) < p) return fit;
  const Eigen::VectorXd first = pivoted_least_squares(design, rough);
  const double spread =
      (rough - design * first).norm() / std::sqrt(static_cast<double>(rough.size()));
  if (!(spread > 1e-9 * (1 + rough.cwiseAbs().maxCoeff()))) return fit;

  Eigen::VectorXd start(p + 1);
  start << first / spread, 1 / spread;
  const auto maximum = maximize<Eigen::Dynamic>(
      [&](const Eigen::VectorXd& point) { return likelihood(design, values, positive, point); },
      start);
  const double h = maximum.point[p];
  if (!maximum.found || !(h > 1e-9 / spread)) return fit;
  fit.found = true;
  fit.sigma = 1 / h;
  fit.coefficients = maximum.point.head(p) / h;
  fit.log_likelihood = maximum.at.value;
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(p + 1, p + 1);
  jacobian.topLeftCorner(p, p).diagonal().setConstant(1 / h);
  jacobian.topRightCorner(p, 1) = -fit.coefficients / h;
  jacobian(p, p) = -1 / h;
  const Eigen::MatrixXd inverse = maximum.at.curvature.inverse();
  fit.covariance = jacobian * inverse * jacobian.transpose();
  const Eigen::MatrixXd scores = spread_of_scores(design, values, groups, maximum.point);
  fit.cluster_covariance =
      scores.isZero(0)
          ? fit.covariance
          : Eigen::MatrixXd(jacobian * inverse * scores * inverse * jacobian.transpose());
  return fit;
}

}  // namespace gurney::statistics
