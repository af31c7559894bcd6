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
std::optional<TrialFault> evaluate(MeasuredTrial& made) {
  if (auto fault = check_samples(made.trial)) return fault;
  TrialFault fault;
  made.phases = find_phases(made.trial, fault);
  if (!made.phases) return fault;
  if (auto bad = check_phases(made.trial, *made.phases)) return bad;
  made.averages = averages_of(made.trial, *made.phases, fault);
  if (!made.averages) return fault;
  if (made.trial.kind != TrialKind::kPull) return {};
  return check_averages(*made.averages, !made.trial.signals.displacement.empty());
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
    MeasuredTrial made{trial, {}, {}, {}};
    if (const auto fault = evaluate(made)) {
      made.averages = {};
      made.fault = fault->text();
    }
    all.push_back(std::move(made));
  }
  for (const TrialAverages& averages : set.averages) {
    MeasuredTrial made;
    made.trial.name = averages.name;
    made.trial.file = averages.file;
    made.trial.setup = averages.setup;
    made.averages = averages;
    all.push_back(std::move(made));
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
