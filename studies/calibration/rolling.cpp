#include "studies/calibration/rolling.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>

#include "studies/statistics/random_effects.h"
#include "studies/statistics/special.h"

namespace gurney {
namespace {

constexpr double kOutlier = 0.05;

struct Logarithms {
  Eigen::VectorXd y, error;
};

Logarithms logarithms(const std::vector<double>& values, const std::vector<double>& errors) {
  const auto n = static_cast<Eigen::Index>(values.size());
  Logarithms logs{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    logs.y[i] = std::log(values[at]);
    logs.error[i] = errors[at] / values[at];
  }
  return logs;
}

}  // namespace

double RollingTrial::ratio() const { return resistance.mean / normal_force(averages.setup); }
double RollingTrial::error() const { return resistance.mean_error / normal_force(averages.setup); }

TrialConstant constant_of(const std::vector<double>& values, const std::vector<double>& errors,
                          std::vector<std::string> names) {
  const Logarithms logs = logarithms(values, errors);
  TrialConstant constant;
  constant.trials = std::move(names);
  constant.value = std::exp(logs.y.mean());
  constant.interval = constant.prediction = {0, std::numeric_limits<double>::infinity()};
  const auto fit = fit_random_effects(logs.y, logs.error, Eigen::MatrixXd::Ones(logs.y.size(), 1));
  if (!fit) return constant;
  const double middle = fit->coefficients[0];
  const Interval interval = fit->interval(0);
  constant.value = std::exp(middle);
  constant.interval = {std::exp(interval.low), std::exp(interval.high)};
  constant.scatter = fit->scatter;
  constant.degrees = fit->degrees;
  const double spread = std::sqrt(fit->covariance(0, 0) + fit->scatter * fit->scatter +
                                  logs.error.squaredNorm() / static_cast<double>(logs.y.size()));
  const double half = student_quantile(0.975, fit->degrees) * spread;
  constant.prediction = {std::exp(middle - half), std::exp(middle + half)};
  return constant;
}

std::vector<Outlier> outliers_of(const std::string& constant, const std::vector<double>& values,
                                 const std::vector<double>& errors,
                                 const std::vector<std::string>& names) {
  const Logarithms logs = logarithms(values, errors);
  const std::vector<double> p =
      outlier_p_values(logs.y, logs.error, Eigen::MatrixXd::Ones(logs.y.size(), 1));
  std::vector<Outlier> found;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p[i] < kOutlier) found.push_back({names[i], constant, values[i], p[i]});
  return found;
}

RollingCalibration calibrate_rolling(const std::vector<TrialAverages>& trials) {
  RollingCalibration result;
  std::map<std::pair<std::string, std::string>, RollingGroup> groups;
  for (const TrialAverages& averages : trials) {
    const TrialSetup& setup = averages.setup;
    RollingGroup& group = groups[{setup.caster, setup.floor}];
    group.caster = setup.caster;
    group.floor = setup.floor;
    group.wheel_radius = setup.wheel_radius;
    group.trials.push_back(result.trials.size());
    result.trials.push_back({averages, average_method(averages)});
  }
  for (auto& [key, group] : groups) {
    std::vector<double> values, errors;
    std::vector<std::string> names;
    for (const std::size_t i : group.trials) {
      values.push_back(result.trials[i].ratio());
      errors.push_back(result.trials[i].error());
      names.push_back(result.trials[i].averages.name);
    }
    const std::string name = fmt::format("Cr/R of {} on {}", group.caster, group.floor);
    for (Outlier& outlier : outliers_of(name, values, errors, names))
      result.outliers.push_back(std::move(outlier));
    group.ratio = constant_of(values, errors, std::move(names));
    result.groups.push_back(std::move(group));
  }
  result.tests = rolling_tests(result.trials);
  return result;
}

}  // namespace gurney
