#include "studies/calibration/fit/rolling.h"

#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "studies/statistics/random_effects.h"
#include "studies/statistics/two_groups.h"

namespace gurney::calibration {
namespace {

using Trials = std::vector<const RollingTrial*>;
using Label = std::function<std::string(const RollingTrial&)>;
using Number = std::function<double(const RollingTrial&)>;

std::string group_of(const RollingTrial& t) {
  return t.averages.setup.caster + "\n" + t.averages.setup.floor;
}
std::string caster_of(const RollingTrial& t) { return t.averages.setup.caster; }
std::string floor_of(const RollingTrial& t) { return t.averages.setup.floor; }
std::string tread_of(const RollingTrial& t) { return t.averages.setup.tread; }

/// Columns of 0 and 1, one for each label; without that of the first where `later` is set.
void add_factor(Eigen::MatrixXd& design, const Trials& trials, const Label& label, bool later) {
  std::map<std::string, Eigen::Index> columns;
  for (const RollingTrial* trial : trials) columns[label(*trial)] = 0;
  Eigen::Index next = design.cols() - (later ? 1 : 0);
  for (auto& [name, column] : columns) column = next++;
  const Eigen::Index first = design.cols();
  design.conservativeResize(static_cast<Eigen::Index>(trials.size()), next);
  design.rightCols(next - first).setZero();
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const Eigen::Index column = columns[label(*trials[i])];
    if (column >= first) design(static_cast<Eigen::Index>(i), column) = 1;
  }
}

void add_number(Eigen::MatrixXd& design, const Trials& trials, const Number& number) {
  const Eigen::Index column = design.cols();
  design.conservativeResize(static_cast<Eigen::Index>(trials.size()), column + 1);
  for (std::size_t i = 0; i < trials.size(); ++i)
    design(static_cast<Eigen::Index>(i), column) = number(*trials[i]);
}

std::optional<statistics::RandomEffects> fit_logarithms(const Trials& trials,
                                                        const Eigen::MatrixXd& design) {
  Eigen::VectorXd y(trials.size()), error(trials.size());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    y[static_cast<Eigen::Index>(i)] = std::log(trials[i]->ratio());
    error[static_cast<Eigen::Index>(i)] = trials[i]->error() / trials[i]->ratio();
  }
  return statistics::fit_random_effects(y, error, design);
}

/// A test of the coefficient in column `i` plus `offset`.
RollingTest test_of(const statistics::RandomEffects& fit, Eigen::Index i, double offset,
                    double supposed, std::string name, std::string quantity) {
  const statistics::Interval interval = fit.interval(i);
  RollingTest test;
  test.name = std::move(name);
  test.quantity = std::move(quantity);
  test.estimate = fit.coefficients[i] + offset;
  test.interval = {interval.low + offset, interval.high + offset};
  test.supposed = supposed;
  test.p = fit.p_value(i, supposed - offset);
  test.trials = fit.degrees + static_cast<int>(fit.coefficients.size());
  return test;
}

void as_ratio(RollingTest& test) {
  test.estimate = std::exp(test.estimate);
  test.interval = {std::exp(test.interval.low), std::exp(test.interval.high)};
  test.supposed = std::exp(test.supposed);
}

/// Each group its level, and one number besides.
void test_within_groups(const Trials& trials, const Number& number, double offset, double supposed,
                        const char* name, const char* quantity, std::vector<RollingTest>& tests) {
  Eigen::MatrixXd design(static_cast<Eigen::Index>(trials.size()), 0);
  add_factor(design, trials, group_of, false);
  add_number(design, trials, number);
  if (const auto fit = fit_logarithms(trials, design))
    tests.push_back(test_of(*fit, design.cols() - 1, offset, supposed, name, quantity));
}

void test_floors(const Trials& trials, std::vector<RollingTest>& tests) {
  std::set<std::string> floors;
  for (const RollingTrial* trial : trials) floors.insert(floor_of(*trial));
  if (floors.size() < 2) return;
  Eigen::MatrixXd design(static_cast<Eigen::Index>(trials.size()), 0);
  add_factor(design, trials, caster_of, false);
  Eigen::Index column = design.cols();
  add_factor(design, trials, floor_of, true);
  const auto fit = fit_logarithms(trials, design);
  if (!fit) return;
  const std::string first = *floors.begin();
  for (auto floor = std::next(floors.begin()); floor != floors.end(); ++floor) {
    tests.push_back(test_of(*fit, column++, 0, 0, "floor " + *floor, "f_r over that on " + first));
    as_ratio(tests.back());
  }
}

/// Only treads that are stated.
void test_diameters(const Trials& trials, std::vector<RollingTest>& tests) {
  Trials stated;
  for (const RollingTrial* trial : trials)
    if (!tread_of(*trial).empty()) stated.push_back(trial);
  if (stated.empty()) return;
  Eigen::MatrixXd design(static_cast<Eigen::Index>(stated.size()), 0);
  add_factor(design, stated, tread_of, false);
  add_factor(design, stated, floor_of, true);
  add_number(design, stated,
             [](const RollingTrial& t) { return std::log(t.averages.setup.wheel_radius); });
  const auto fit = fit_logarithms(stated, design);
  if (!fit) return;
  tests.push_back(test_of(*fit, design.cols() - 1, 0, -1, "diameter", "m in f_r ~ R^m"));
  tests.back().p_without = fit->p_value(design.cols() - 1, 0);
}

/// One number of each trial by itself, with its error.
void test_mean(const Trials& trials, const Number& value, const Number& error, const char* name,
               const char* quantity, std::vector<RollingTest>& tests) {
  std::vector<double> values, errors;
  for (const RollingTrial* trial : trials)
    if (std::isfinite(value(*trial))) {
      values.push_back(value(*trial));
      errors.push_back(error(*trial));
    }
  const auto n = static_cast<Eigen::Index>(values.size());
  const auto fit = statistics::fit_random_effects(Eigen::Map<Eigen::VectorXd>(values.data(), n),
                                                  Eigen::Map<Eigen::VectorXd>(errors.data(), n),
                                                  Eigen::MatrixXd::Ones(n, 1));
  if (fit) tests.push_back(test_of(*fit, 0, 0, 0, name, quantity));
}

/// Mean speed as it were with the mean Cr / R of its group: by itself a trial that resists more is
/// slower. A weight that drops by the same height gives a speed ~ sqrt(a_2).
Number usual_speed(const Trials& trials) {
  std::map<std::string, std::pair<double, int>> sums;
  for (const RollingTrial* trial : trials) {
    auto& [sum, count] = sums[group_of(*trial)];
    sum += std::log(trial->ratio());
    ++count;
  }
  return [sums](const RollingTrial& t) {
    const auto& [sum, count] = sums.at(group_of(t));
    const TrialAverages& a = t.averages;
    const double usual =
        (a.pull_force - a.setup.string_tension - std::exp(sum / count) * normal_force(a.setup)) /
        (a.setup.mass + a.setup.added_mass);
    const double speed = (a.pull_speed + a.coast_speed) / 2;
    return usual > 0 ? speed * std::sqrt(usual / a.pull_acceleration) : speed;
  };
}

double per_resistance(const RollingTrial& t) {
  return (t.averages.setup.mass + t.averages.setup.added_mass) / t.resistance.coasting;
}

}  // namespace

double RollingTrial::ratio() const { return resistance.mean / normal_force(averages.setup); }
double RollingTrial::error() const { return resistance.mean_error / normal_force(averages.setup); }

TrialValue value_of(const RollingTrial& trial) {
  return {ConstantKind::kRolling, trial.averages.name, trial.averages.setup, trial.ratio(),
          trial.error()};
}

std::vector<RollingTest> rolling_tests(const std::vector<RollingTrial>& all) {
  Trials trials;
  for (const RollingTrial& trial : all) trials.push_back(&trial);
  std::vector<RollingTest> tests;
  if (trials.empty()) return tests;
  test_within_groups(
      trials, [](const RollingTrial& t) { return std::log(normal_force(t.averages.setup)); }, 1, 1,
      "load", "n in f_r ~ N^n", tests);
  test_within_groups(trials, usual_speed(trials), 0, 0, "speed between trials",
                     "d ln f_r / dv (s/m)", tests);
  test_mean(
      trials,
      [](const RollingTrial& t) {
        return t.averages.slope ? *t.averages.slope * per_resistance(t) : std::nan("");
      },
      [](const RollingTrial& t) { return t.averages.slope_error * per_resistance(t); },
      "speed while coasting", "d ln f_r / dv (s/m)", tests);
  test_diameters(trials, tests);
  test_floors(trials, tests);
  test_mean(
      trials,
      [](const RollingTrial& t) { return std::log(t.resistance.pulled / t.resistance.coasting); },
      [](const RollingTrial& t) {
        return std::hypot(t.resistance.pulled_error / t.resistance.pulled,
                          t.resistance.coasting_error / t.resistance.coasting);
      },
      "phase", "f_r pulled over f_r coasting", tests);
  if (!tests.empty() && tests.back().name == "phase") as_ratio(tests.back());
  std::vector<double> p;
  for (const RollingTest& test : tests) p.push_back(test.p);
  const std::vector<double> adjusted = statistics::holm_adjusted(p);
  for (std::size_t i = 0; i < tests.size(); ++i) tests[i].p_adjusted = adjusted[i];
  return tests;
}

}  // namespace gurney::calibration
