#include "groundmotions/scaling/suite_scaling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "engine/base/error.h"

namespace gurney::groundmotions {
namespace {

/// Trapezoidal weights of ln T with the sum 1.
Eigen::VectorXd weights_of(const Eigen::VectorXd& periods) {
  const Eigen::Index n = periods.size();
  const Eigen::VectorXd x = periods.array().log();
  Eigen::VectorXd w = Eigen::VectorXd::Zero(n);
  for (Eigen::Index j = 1; j < n; ++j) {
    w[j - 1] += (x[j] - x[j - 1]) / 2;
    w[j] += (x[j] - x[j - 1]) / 2;
  }
  return w / (x[n - 1] - x[0]);
}

void check(const Eigen::VectorXd& periods, const Eigen::MatrixXd& spectra,
           const Eigen::VectorXd& target, const std::vector<std::string>& names,
           const SuiteScalingOptions& options) {
  const Eigen::Index n = periods.size();
  require(n >= 2 && (periods.array() > 0).all() &&
              (periods.tail(n - 1).array() > periods.head(n - 1).array()).all(),
          "suite scaling needs at least two periods > 0 that grow");
  require(spectra.rows() >= 1 && spectra.cols() == n && target.size() == n &&
              static_cast<Eigen::Index>(names.size()) == spectra.rows(),
          fmt::format("suite scaling: {} records with {} names, {} ordinates each, {} of the "
                      "target, for {} periods",
                      spectra.rows(), names.size(), spectra.cols(), target.size(), n));
  require((target.array() > 0).all() && target.allFinite(),
          "suite scaling: the target must be > 0 at all periods");
  for (Eigen::Index i = 0; i < spectra.rows(); ++i)
    require((spectra.row(i).array() > 0).all() && spectra.row(i).allFinite(),
            names[static_cast<std::size_t>(i)] +
                ": its spectrum must be > 0 at all periods of the range");
  require(options.smallest_factor >= 0 && options.largest_factor > options.smallest_factor,
          fmt::format("limits of factors {:g} to {:g}: must be >= 0 and grow",
                      options.smallest_factor, options.largest_factor));
  require(options.floor_share >= 0, "the share of the target must be >= 0");
}

Eigen::VectorXd mean_of(const Eigen::MatrixXd& spectra, SuiteScalingOptions::Mean mean) {
  if (mean == SuiteScalingOptions::Mean::kArithmetic) return spectra.colwise().mean().transpose();
  return spectra.array().log().matrix().colwise().mean().transpose().array().exp();
}

constexpr double kSteeper = 2;  ///< than the steepest interval nearby
constexpr int kRounds = 24;     ///< halve an interval to 1e-7 of its length

using Points = std::map<double, double>;  ///< ratio by ln T

double steepness(Points::const_iterator at) {
  const auto next = std::next(at);
  return std::abs(next->second - at->second) / (next->first - at->first);
}

/// The middles of the intervals that may hold a ratio below `bound`: between two ratios a function
/// of the slope s goes down to their mean less s times half the interval.
std::vector<double> middles_below(const Points& points, double bound) {
  std::vector<double> middles;
  for (auto at = points.begin(); std::next(at) != points.end(); ++at) {
    const auto next = std::next(at);
    double slope = steepness(at);
    if (at != points.begin()) slope = std::max(slope, steepness(std::prev(at)));
    if (std::next(next) != points.end()) slope = std::max(slope, steepness(next));
    const double least =
        (at->second + next->second) / 2 - kSteeper * slope * (next->first - at->first) / 2;
    if (least < bound) middles.push_back((at->first + next->first) / 2);
  }
  return middles;
}

Points::const_iterator lowest_of(const Points& points) {
  return std::ranges::min_element(points, {}, [](const auto& point) { return point.second; });
}

}  // namespace

SuiteScaling scale_suite(const Eigen::VectorXd& periods, const Eigen::MatrixXd& spectra,
                         const Eigen::VectorXd& target, const std::vector<std::string>& names,
                         const SuiteScalingOptions& options) {
  check(periods, spectra, target, names, options);
  const Eigen::VectorXd w = weights_of(periods);
  const Eigen::MatrixXd ln_ratio =  // ln(Sa / target), records by periods
      spectra.array().log().matrix().rowwise() - target.array().log().matrix().transpose();

  SuiteScaling result;
  Eigen::VectorXd ln_factor = -(ln_ratio * w);
  if (!options.own_factors) ln_factor.setConstant(ln_factor.mean());
  result.factors = ln_factor.array().exp();
  for (Eigen::Index i = 0; i < result.factors.size(); ++i) {
    const double wanted = result.factors[i];
    result.factors[i] = std::clamp(wanted, options.smallest_factor, options.largest_factor);
    if (result.factors[i] != wanted)
      result.warnings.push_back(
          fmt::format("{}: the best factor is {:.4g}, held at the limit {:.4g}",
                      names[static_cast<std::size_t>(i)], wanted, result.factors[i]));
  }

  result.mean = mean_of(result.factors.asDiagonal() * spectra, options.mean);
  const Eigen::VectorXd mean_ratio = result.mean.array() / target.array();
  result.common_factor = options.floor_share > 0
                             ? options.floor_share / mean_ratio.minCoeff()
                             : std::exp(-mean_ratio.array().log().matrix().dot(w));
  result.own_factors = result.factors;
  result.factors *= result.common_factor;
  for (Eigen::Index i = 0; i < result.factors.size(); ++i)
    if (result.factors[i] > options.largest_factor || result.factors[i] < options.smallest_factor)
      result.warnings.push_back(fmt::format(
          "{}: with the common factor the factor is {:.4g}, outside the limits {:.4g} to {:.4g}",
          names[static_cast<std::size_t>(i)], result.factors[i], options.smallest_factor,
          options.largest_factor));
  result.mean *= result.common_factor;

  Eigen::Index smallest = 0;
  result.smallest_ratio = mean_ratio.minCoeff(&smallest) * result.common_factor;
  result.period_of_smallest = periods[smallest];
  const Eigen::MatrixXd ln_after = ln_ratio.colwise() + result.factors.array().log().matrix();
  result.misfits = (ln_after.array().square().matrix() * w).array().sqrt();
  result.suite_misfit =
      std::sqrt((result.mean.array() / target.array()).log().square().matrix().dot(w));
  return result;
}

SuiteScaling scale_suite(const Eigen::VectorXd& periods, const SuiteSpectra& spectra,
                         const std::vector<std::string>& names,
                         const SuiteScalingOptions& options) {
  constexpr double kTolerance = 1e-4;
  const auto target_at = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
    return at.unaryExpr([&](double period) { return spectra.target(period); });
  };
  const Eigen::MatrixXd at_periods = spectra.records(periods);
  const Eigen::VectorXd target = target_at(periods);
  SuiteScaling coarse = scale_suite(periods, at_periods, target, names, options);
  if (options.floor_share <= 0) return coarse;
  const auto ratios_at = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
    return mean_of(coarse.factors.asDiagonal() * spectra.records(at), options.mean).array() /
           target_at(at).array();
  };
  const LowestRatio lowest =
      lowest_ratio(periods, coarse.mean.array() / target.array(), ratios_at, kTolerance);
  SuiteScalingOptions raised = options;
  raised.floor_share *= coarse.smallest_ratio / lowest.ratio / (1 - kTolerance);
  SuiteScaling result = scale_suite(periods, at_periods, target, names, raised);
  result.smallest_ratio = lowest.ratio * result.common_factor / coarse.common_factor;
  result.period_of_smallest = lowest.period;
  return result;
}

LowestRatio lowest_ratio(const Eigen::VectorXd& periods, const Eigen::VectorXd& ratios,
                         const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& ratios_at,
                         double tolerance) {
  Points points;
  for (Eigen::Index i = 0; i < periods.size(); ++i) points[std::log(periods[i])] = ratios[i];
  for (int round = 0; round < kRounds; ++round) {
    const auto middles = middles_below(points, lowest_of(points)->second * (1 - tolerance));
    if (middles.empty()) break;
    const Eigen::VectorXd at =
        Eigen::Map<const Eigen::ArrayXd>(middles.data(), std::ssize(middles)).exp();
    const Eigen::VectorXd found = ratios_at(at);
    for (Eigen::Index i = 0; i < at.size(); ++i)
      points[middles[static_cast<std::size_t>(i)]] = found[i];
  }
  const auto lowest = lowest_of(points);
  return {std::exp(lowest->first), lowest->second};
}

}  // namespace gurney::groundmotions
