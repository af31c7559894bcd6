#include "studies/calibration/fit/constants.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "studies/statistics/random_effects.h"
#include "studies/statistics/special.h"

namespace gurney::calibration {
namespace {

constexpr double kOutlier = 0.05;

using Key = std::tuple<ConstantKind, std::string, std::string, std::string>;
using Groups = std::map<Key, std::vector<const TrialValue*>>;

Key key_of(const TrialValue& o) {
  if (o.kind == ConstantKind::kRestitution) return {o.kind, "", "", o.setup.against};
  return {o.kind, o.setup.caster, o.setup.floor, ""};
}

/// Those for calibration.
Groups groups_of(const std::vector<TrialValue>& values) {
  Groups groups;
  for (const TrialValue& each : values)
    if (each.setup.use == TrialUse::kCalibration) groups[key_of(each)].push_back(&each);
  const auto bounds = [](const TrialValue* each) { return each->at_least; };
  for (auto& [key, group] : groups)
    if (!std::ranges::all_of(group, bounds)) std::erase_if(group, bounds);
  return groups;
}

struct Logarithms {
  Eigen::VectorXd y, error;
  Eigen::MatrixXd design;
};

Logarithms logarithms(const std::vector<const TrialValue*>& group) {
  const auto n = static_cast<Eigen::Index>(group.size());
  Logarithms logs{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::MatrixXd::Ones(n, 1)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const TrialValue& each = *group[static_cast<std::size_t>(i)];
    logs.y[i] = std::log(each.value);
    logs.error[i] = each.error / each.value;
  }
  return logs;
}

Constant constant_of(const Key& key, const std::vector<const TrialValue*>& group) {
  Constant constant;
  std::tie(constant.kind, constant.caster, constant.floor, constant.against) = key;
  constant.wheel_radius = group[0]->setup.wheel_radius;
  constant.at_least = group[0]->at_least;
  for (const TrialValue* each : group) constant.trials.push_back(each->trial);
  const Logarithms logs = logarithms(group);
  constant.value = std::exp(logs.y.mean());
  constant.interval = constant.prediction = {0, std::numeric_limits<double>::infinity()};
  const auto fit = statistics::fit_random_effects(logs.y, logs.error, logs.design);
  if (!fit) return constant;
  const double middle = fit->coefficients[0];
  const statistics::Interval interval = fit->interval(0);
  constant.value = std::exp(middle);
  constant.interval = {std::exp(interval.low), std::exp(interval.high)};
  constant.scatter = fit->scatter;
  constant.degrees = fit->degrees;
  const double spread = std::sqrt(fit->covariance(0, 0) + fit->scatter * fit->scatter +
                                  logs.error.squaredNorm() / static_cast<double>(logs.y.size()));
  const double half = statistics::student_quantile(0.975, fit->degrees) * spread;
  constant.prediction = {std::exp(middle - half), std::exp(middle + half)};
  if (constant.at_least)
    constant.interval.high = constant.prediction.high = std::numeric_limits<double>::infinity();
  return constant;
}

constexpr std::array kSymbols = {"Cr/R", "Cr/R at start",       "mu_s", "mu_k",
                                 "e",    "swivel torque over N"};
constexpr std::array kNames = {"rolling_resistance", "start_up_resistance", "static_friction",
                               "kinetic_friction",   "restitution",         "swivel_torque"};

}  // namespace

const char* symbol_of(ConstantKind kind) { return kSymbols[static_cast<std::size_t>(kind)]; }
const char* name_of(ConstantKind kind) { return kNames[static_cast<std::size_t>(kind)]; }
const char* unit_of(ConstantKind kind) { return kind == ConstantKind::kSwivelTorque ? "m" : "1"; }

std::string TrialValue::constant() const {
  Constant of;
  std::tie(of.kind, of.caster, of.floor, of.against) = key_of(*this);
  return of.about();
}

std::string Constant::about() const {
  if (kind == ConstantKind::kRestitution) return fmt::format("e against {}", against);
  return fmt::format("{} of {} on {}", symbol_of(kind), caster, floor);
}

std::vector<Constant> constants_of(const std::vector<TrialValue>& values) {
  std::vector<Constant> constants;
  for (const auto& [key, group] : groups_of(values)) constants.push_back(constant_of(key, group));
  return constants;
}

std::vector<Outlier> outliers_of(const std::vector<TrialValue>& values) {
  const Groups groups = groups_of(values);
  std::vector<Outlier> found;
  for (auto first = groups.begin(); first != groups.end();) {
    auto last = first;  // all groups of one kind
    std::vector<const TrialValue*> all;
    std::vector<std::pair<std::string, Eigen::Index>> members;
    Eigen::Index count = 0;
    for (; last != groups.end() && std::get<0>(last->first) == std::get<0>(first->first); ++last) {
      const std::string about = constant_of(last->first, last->second).about();
      for (const TrialValue* each : last->second) {
        all.push_back(each);
        members.emplace_back(about, count);
      }
      ++count;
    }
    const Logarithms logs = logarithms(all);
    Eigen::MatrixXd design = Eigen::MatrixXd::Zero(logs.y.size(), count);
    for (std::size_t i = 0; i < all.size(); ++i)
      design(static_cast<Eigen::Index>(i), members[i].second) = 1;
    const std::vector<double> p = statistics::outlier_p_values(logs.y, logs.error, design);
    for (std::size_t i = 0; i < p.size(); ++i)
      if (p[i] < kOutlier) found.push_back({all[i]->trial, members[i].first, all[i]->value, p[i]});
    first = last;
  }
  return found;
}

std::vector<Prediction> predictions_of(const std::vector<TrialValue>& values,
                                       const std::vector<Constant>& constants,
                                       std::vector<std::string>& unpredicted) {
  std::map<Key, const Constant*> known;
  for (const Constant& each : constants)
    known[{each.kind, each.caster, each.floor, each.against}] = &each;
  std::vector<Prediction> predictions;
  for (const TrialValue& each : values) {
    if (each.setup.use != TrialUse::kValidation) continue;
    const auto found = known.find(key_of(each));
    if (found != known.end() && (each.at_least || found->second->at_least))
      unpredicted.push_back(
          fmt::format("{}: only a bound of {}", each.trial, symbol_of(each.kind)));
    else if (found == known.end())
      unpredicted.push_back(
          fmt::format("{}: no calibration trial gives its {}", each.trial, symbol_of(each.kind)));
    else
      predictions.push_back({each.trial, found->second->about(), each.value, found->second->value,
                             found->second->prediction});
  }
  return predictions;
}

}  // namespace gurney::calibration
