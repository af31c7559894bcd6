#include "studies/calibration/pulling/measured_trial.h"

#include <algorithm>
#include <cmath>

#include "studies/calibration/trials/trial_check.h"
#include "studies/calibration/trials/trial_file.h"

namespace gurney::calibration {
namespace {

constexpr double kAlike = 0.02;

bool near(double a, double b) { return std::abs(a - b) <= kAlike * std::max(a, b); }

bool is_pull(TrialKind kind) {
  return kind == TrialKind::kPull || kind == TrialKind::kCrosswisePull;
}

/// What is wrong with its samples, else the method's phases and averages.
std::optional<TrialFault> evaluate(MeasuredTrial& result) {
  if (auto fault = check_samples(result.trial)) return fault;
  TrialFault fault;
  result.phases = find_phases(result.trial, fault);
  if (!result.phases) return fault;
  if (auto bad = check_phases(result.trial, *result.phases)) return bad;
  result.averages = averages_of(result.trial, *result.phases, fault);
  if (!result.averages) return fault;
  if (result.trial.kind != TrialKind::kPull) return {};
  return check_averages(*result.averages, !result.trial.signals.displacement.empty());
}

bool alike(const TrialSetup& a, Alignment of_a, const TrialSetup& b) {
  return a.caster == b.caster && a.floor == b.floor && of_a == alignment_of(b.headings) &&
         near(a.mass, b.mass) && near(a.drop_mass.value_or(0), b.drop_mass.value_or(0));
}

}  // namespace

std::vector<MeasuredTrial> measured_trials(const std::string& path) {
  const TrialSet set = read_trials(path);
  std::vector<MeasuredTrial> all;
  for (const Trial& trial : set.trials) {
    if (!is_pull(trial.kind)) continue;
    MeasuredTrial result{trial, {}, {}, {}};
    if (const auto fault = evaluate(result)) {
      result.averages = {};
      result.fault = fault->text();
    }
    all.push_back(std::move(result));
  }
  for (const TrialAverages& averages : set.averages) {
    MeasuredTrial result;
    result.trial.name = averages.name;
    result.trial.file = averages.file;
    result.trial.setup = averages.setup;
    result.averages = averages;
    all.push_back(std::move(result));
  }
  return all;
}

const MeasuredTrial* find_matching(const SimulatedTrial& simulated,
                                   const std::vector<MeasuredTrial>& measured) {
  for (const MeasuredTrial& each : measured)
    if (each.fault.empty() && alike(simulated.trial.setup, simulated.alignment, each.trial.setup))
      return &each;
  return nullptr;
}

}  // namespace gurney::calibration
