#include "studies/statistics/vector_fragility.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "studies/statistics/special.h"

namespace gurney::statistics {
namespace {

constexpr double kTogether = 1 - 1e-9;  // correlation of the logarithms
constexpr double kSingular = 1e-9;      // of the information of standardised logarithms

/// Slope of one run's ln likelihood at a score z, and its curvature.
struct Slope {
  double value, slope, curvature;
};

Slope slope_at(double z, bool exceeded) {
  const double sign = exceeded ? 1 : -1;
  const double hazard = normal_hazard_below(sign * z);
  return {log_normal_cdf(sign * z), sign * hazard, hazard * (hazard + sign * z)};
}

/// (ln first, ln second) less their means over their deviations, and 1: rows.
struct Standardised {
  std::vector<Eigen::Vector3d> rows;
  Eigen::Matrix3d back;  ///< plane of the logarithms = back * plane of the rows
  double correlation = 0;
};

Standardised standardised(const std::vector<VectorObservation>& observations) {
  std::vector<Eigen::Vector2d> logs;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const VectorObservation& each : observations) {
    logs.emplace_back(std::log(each.first), std::log(each.second));
    mean += logs.back() / static_cast<double>(observations.size());
  }
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& each : logs)
    spread += (each - mean) * (each - mean).transpose() / static_cast<double>(logs.size());
  Standardised result;
  const Eigen::Vector2d deviation = spread.diagonal().cwiseSqrt();
  result.correlation = spread(0, 1) / (deviation[0] * deviation[1]);
  for (const Eigen::Vector2d& each : logs)
    result.rows.emplace_back((each[0] - mean[0]) / deviation[0], (each[1] - mean[1]) / deviation[1],
                             1);
  result.back << 1 / deviation[0], 0, 0, 0, 1 / deviation[1], 0, -mean[0] / deviation[0],
      -mean[1] / deviation[1], 1;
  return result;
}

/// Whether a plane leaves no run on its wrong side.
bool parts(const Eigen::Vector3d& plane, const Standardised& at,
           const std::vector<VectorObservation>& observations) {
  for (std::size_t i = 0; i < observations.size(); ++i)
    if ((plane.dot(at.rows[i]) > 0) != observations[i].exceeded) return false;
  return true;
}

Eigen::Matrix3d spread_of_scores(const Eigen::Vector3d& plane, const Standardised& at,
                                 const std::vector<VectorObservation>& observations) {
  std::map<std::size_t, Eigen::Vector3d> scores;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const double slope = slope_at(plane.dot(at.rows[i]), observations[i].exceeded).slope;
    scores.try_emplace(observations[i].group, Eigen::Vector3d::Zero()).first->second +=
        slope * at.rows[i];
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& [group, score] : scores) spread += score * score.transpose();
  const double groups = static_cast<double>(scores.size());
  return groups > 1 ? Eigen::Matrix3d(groups / (groups - 1) * spread) : Eigen::Matrix3d::Zero();
}

VectorStatus status_of_outcomes(const VectorFit& fit, const Standardised& at) {
  if (fit.exceeded == fit.runs) return VectorStatus::kAllExceed;
  if (fit.exceeded == 0) return VectorStatus::kNoneExceeds;
  if (!(std::abs(at.correlation) < kTogether)) return VectorStatus::kTogether;
  return VectorStatus::kFitted;
}

}  // namespace

std::string text(VectorStatus status) {
  switch (status) {
    case VectorStatus::kFitted:
      return "fitted";
    case VectorStatus::kNoRuns:
      return "no runs";
    case VectorStatus::kAllExceed:
      return "every run exceeds";
    case VectorStatus::kNoneExceeds:
      return "no run exceeds";
    case VectorStatus::kTogether:
      return "one measure is a power of the other in these runs, so their parts cannot be "
             "separated";
    case VectorStatus::kSeparated:
      return "separated, or nearly: a line in the plane of both measures parts the runs that "
             "exceed "
             "from the others, so slopes are not determined";
    case VectorStatus::kInAllBrackets:
      return "separated: a line in the plane of both measures runs through the brackets of all "
             "capacities, so slopes are not determined";
    case VectorStatus::kNotIncreasing:
      return "exceedance does not increase with both measures together";
  }
  return {};
}

double VectorFit::probability(double first, double second) const {
  return normal_cdf(plane.dot(Eigen::Vector3d(std::log(first), std::log(second), 1)));
}

double VectorFit::share() const { return plane[0] / (plane[0] + plane[1]); }

double VectorFit::theta() const { return std::exp(-plane[2] / (plane[0] + plane[1])); }

double VectorFit::beta() const { return 1 / (plane[0] + plane[1]); }

double VectorFit::p_of(Eigen::Index slope) const {
  const double far = std::abs(t[slope]);
  return degrees > 0 ? 2 * student_survival(far, degrees) : 2 * normal_cdf(-far);
}

VectorFit fit_vector(const std::vector<VectorObservation>& observations) {
  VectorFit fit;
  std::map<std::size_t, std::size_t> groups;
  for (const VectorObservation& each : observations) {
    for (const double im : {each.first, each.second})
      require(im > 0 && std::isfinite(im),
              fmt::format("an intensity is {:g}: must be > 0 and finite", im));
    ++groups[each.group];
    fit.exceeded += each.exceeded;
  }
  fit.runs = observations.size();
  fit.groups = groups.size();
  fit.degrees = static_cast<double>(fit.groups) - 1;
  if (observations.empty()) return fit;
  const Standardised at = standardised(observations);
  fit.status = status_of_outcomes(fit, at);
  if (fit.status != VectorStatus::kFitted) return fit;
  const auto maximum = maximize<3>(
      [&](const Eigen::Vector3d& plane) {
        Quadratic<3> sum{0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
        for (std::size_t i = 0; i < observations.size(); ++i) {
          const Eigen::Vector3d& row = at.rows[i];
          const Slope of = slope_at(plane.dot(row), observations[i].exceeded);
          sum.value += of.value;
          sum.gradient += of.slope * row;
          sum.curvature += of.curvature * row * row.transpose();
        }
        return sum;
      },
      Eigen::Vector3d::Zero());
  const Eigen::Matrix3d& information = maximum.at.curvature;
  const double weakest =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(information).eigenvalues()[0];
  if (!maximum.found || !(weakest > kSingular * static_cast<double>(fit.runs)) ||
      parts(maximum.point, at, observations)) {
    fit.status = VectorStatus::kSeparated;
    return fit;
  }
  const Eigen::Matrix3d inverse = information.inverse();
  fit.plane = at.back * maximum.point;
  fit.log_likelihood = maximum.at.value;
  fit.covariance = at.back * inverse * at.back.transpose();
  fit.cluster_covariance = at.back * inverse * spread_of_scores(maximum.point, at, observations) *
                           inverse * at.back.transpose();
  const Eigen::Matrix3d& of = fit.groups > 1 ? fit.cluster_covariance : fit.covariance;
  fit.t = (fit.plane.array() / of.diagonal().array().sqrt()).head<2>();
  if (!(fit.plane[0] + fit.plane[1] > 0)) fit.status = VectorStatus::kNotIncreasing;
  return fit;
}

namespace {

/// Derivatives of the plane of m0, m1 and sigma by (m0, m1, ln sigma).
Eigen::Matrix3d derivatives(const Eigen::Vector3d& plane, double sigma, double power) {
  Eigen::Matrix3d of;
  of << 0, power / sigma, -plane[0], 0, -1 / sigma, -plane[1], -1 / sigma, 0, -plane[2];
  return of;
}

/// Whether a line runs through every bracket: the smaller sigma, the better it explains them.
bool in_all_brackets(const Eigen::VectorXd& line, const std::vector<VectorCapacity>& capacities) {
  return std::ranges::all_of(capacities, [&](const VectorCapacity& each) {
    const double at = line[0] + line[1] * each.ln_ratio;
    return each.ln_first.low <= at && at <= each.ln_first.high;
  });
}

/// Why brackets have no fit; kFitted where that is still to be seen.
VectorStatus status_of_brackets(const std::vector<VectorCapacity>& capacities) {
  const auto all = [&](auto holds) { return std::ranges::all_of(capacities, holds); };
  if (all([](const VectorCapacity& each) { return std::isinf(each.ln_first.high); }))
    return VectorStatus::kNoneExceeds;
  if (all([](const VectorCapacity& each) { return std::isinf(each.ln_first.low); }))
    return VectorStatus::kAllExceed;
  const auto [low, high] = std::ranges::minmax(capacities, {}, &VectorCapacity::ln_ratio);
  // As of fit_vector(): logarithms apart by less than a billionth.
  return high.ln_ratio - low.ln_ratio > 1e-9 ? VectorStatus::kFitted : VectorStatus::kTogether;
}

}  // namespace

VectorFit fit_vector_capacities(const std::vector<VectorCapacity>& capacities, double power) {
  VectorFit fit;
  std::set<std::size_t> groups;
  std::vector<CensoredValue> values;
  Eigen::MatrixXd design(static_cast<Eigen::Index>(capacities.size()), 2);
  double records = 0;
  for (const VectorCapacity& each : capacities) {
    design.row(static_cast<Eigen::Index>(values.size())) << 1, each.ln_ratio;
    values.push_back(each.ln_first);
    groups.insert(each.group);
    fit.exceeded += std::isfinite(each.ln_first.high);
    records += each.ln_first.weight;
  }
  fit.runs = capacities.size();
  fit.groups = groups.size();
  if (capacities.empty()) return fit;
  fit.status = status_of_brackets(capacities);
  if (fit.status != VectorStatus::kFitted) return fit;
  const CensoredNormalFit normal = fit_censored_normal(design, values);
  fit.status = VectorStatus::kInAllBrackets;
  if (!normal.found || in_all_brackets(normal.coefficients, capacities)) return fit;
  const double sigma = normal.sigma, m0 = normal.coefficients[0], m1 = normal.coefficients[1];
  fit.plane = Eigen::Vector3d(1 + power * m1, -m1, -m0) / sigma;
  const double n = std::clamp(0.5 / normal.covariance(2, 2), 3.0, std::max(3.0, records));
  const Eigen::Matrix3d by = derivatives(fit.plane, sigma, power);
  fit.degrees = n - 2;
  fit.covariance = n / (n - 2) * by * normal.covariance * by.transpose();
  fit.cluster_covariance = fit.covariance;
  // A slope m / sigma is 0 where m is, whatever sigma; 1 / sigma never is.
  const double error = std::sqrt(n / (n - 2) * normal.covariance(1, 1));
  fit.t = {power == 0 ? fit.plane[0] / std::sqrt(fit.covariance(0, 0)) : (1 + power * m1) / error,
           -m1 / error};
  fit.log_likelihood = normal.log_likelihood;
  fit.status =
      fit.plane[0] + fit.plane[1] > 0 ? VectorStatus::kFitted : VectorStatus::kNotIncreasing;
  return fit;
}

}  // namespace gurney::statistics
