#include "studies/calibration/pulling/measured_trial.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/calibration/trials/trial_check.h"
#include "studies/calibration/trials/trial_file.h"

namespace gurney::calibration {
namespace {

constexpr double kAlike = 0.02;

bool near(double a, double b) { return std::abs(a - b) <= kAlike * std::max(a, b); }

bool is_pull(TrialKind kind) {
  return kind == TrialKind::kPull || kind == TrialKind::kCrosswisePull;
}

/// The method's phases and averages.
/// @throws UnusableTrial
void evaluate(MeasuredTrial& result) {
  const Trial& trial = result.trial;
  check_samples(trial);
  result.phases = find_phases(trial);
  check_phases(trial, *result.phases);
  const TrialAverages averages = averages_of(trial, *result.phases);
  if (trial.kind == TrialKind::kPull) check_averages(averages, !trial.signals.displacement.empty());
  result.averages = averages;
}

bool alike(const TrialSetup& a, Alignment of_a, const TrialSetup& b) {
  return a.caster == b.caster && a.floor == b.floor && of_a == alignment_of(b.headings) &&
         near(a.mass, b.mass) && near(a.drop_mass.value_or(0), b.drop_mass.value_or(0));
}

double displacement_at(const TrialSignals& s, double time) {
  const auto after = std::ranges::upper_bound(s.time, time) - s.time.begin();
  const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(after), 1, s.time.size() - 1);
  const double share = (time - s.time[i - 1]) / (s.time[i] - s.time[i - 1]);
  return s.displacement[i - 1] + share * (s.displacement[i] - s.displacement[i - 1]);
}

/// Over 0.1 s to either side; the mean of the slopes is that of a speed with a corner in it.
double speed_at(const TrialSignals& s, double time) {
  constexpr double kSide = 0.1;  // [s]
  return (displacement_at(s, time + kSide) - displacement_at(s, time - kSide)) / (2 * kSide);
}

}  // namespace

std::optional<DrivenError> driven_error(const SimulatedTrial& simulated,
                                        const std::vector<MeasuredTrial>& measured) {
  const MeasuredTrial* const match = find_matching(simulated, measured);
  if (match == nullptr || simulated.driven_by != match->trial.name || !simulated.phases ||
      !match->phases || match->trial.signals.displacement.empty())
    return {};
  const TrialSignals &ours = simulated.trial.signals, &theirs = match->trial.signals;
  const Phases& phases = *match->phases;
  const double shift = simulated.phases->start - phases.start, release = phases.release;
  DrivenError error;
  error.release = displacement_at(ours, release + shift) / displacement_at(theirs, release) - 1;
  error.speed = speed_at(ours, release + shift) / speed_at(theirs, release) - 1;
  const bool rested =
      phases.end == Phases::End::kRested && simulated.phases->end == Phases::End::kRested;
  error.rest = rested ? ours.displacement.back() / theirs.displacement.back() - 1
                      : std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < theirs.time.size(); ++i)
    if (theirs.time[i] >= phases.start && theirs.time[i] <= phases.stop &&
        theirs.time[i] + shift <= ours.time.back())
      error.largest = std::max(
          error.largest,
          std::abs(displacement_at(ours, theirs.time[i] + shift) - theirs.displacement[i]));
  return error;
}

std::vector<MeasuredTrial> measured_trials(const std::string& path) {
  const TrialSet set = read_trials(path);
  std::vector<MeasuredTrial> all;
  for (const Trial& trial : set.trials) {
    if (!is_pull(trial.kind)) continue;
    MeasuredTrial result{trial, {}, {}, {}};
    try {
      evaluate(result);
    } catch (const UnusableTrial& error) {
      result.fault = error.what();
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
    if (each.fault.empty() && !simulated.driven_by.empty() &&
        simulated.driven_by == each.trial.name)
      return &each;
  for (const MeasuredTrial& each : measured)
    if (each.fault.empty() && alike(simulated.trial.setup, simulated.alignment, each.trial.setup))
      return &each;
  return nullptr;
}

}  // namespace gurney::calibration
