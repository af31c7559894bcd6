#include "studies/calibration/trials/average_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"

namespace gurney::calibration {
namespace {

constexpr double kAfterStart = 0.15, kAroundRelease = 0.1, kBeforeStop = 0.15;  // [s]
constexpr double kShortest = 0.2;                                               // [s]
constexpr std::size_t kFewest = 12;

struct Mean {
  double value, error;
};

Mean mean_and_error(const std::vector<double>& series, const Span& span) {
  const auto n = static_cast<double>(span.size());
  const double mean = mean_of(series, span);
  double squares = 0;
  for (std::size_t i = span.begin; i < span.end; ++i)
    squares += (series[i] - mean) * (series[i] - mean);
  return {mean, std::sqrt(squares / (n - 1) / n)};
}

Span between(const Trial& trial, double from, double to) {
  return {index_at(trial.signals.time, from), index_at(trial.signals.time, to)};
}

void require_length(const Trial& trial, const Span& span, const std::string& phase) {
  const std::vector<double>& t = trial.signals.time;
  const double length = span.size() > 0 ? t[span.end - 1] - t[span.begin] : 0;
  if (span.size() >= kFewest && length >= kShortest) return;
  const bool coasts = phase == "III";
  refuse(trial, std::min(span.begin, t.size() - 1),
         fmt::format("phase {} is missing: {:.2f} s of it are left {} s after and {} s before its "
                     "ends, at least {} s are needed",
                     phase, length, coasts ? kAroundRelease : kAfterStart,
                     coasts ? kBeforeStop : kAroundRelease, kShortest));
}

void from_displacement(const Trial& trial, const Span& pull, const Span& coast,
                       TrialAverages& averages) {
  const TrialSignals& s = trial.signals;
  const PolynomialFit pulled = fit_polynomial(s.time, s.displacement, pull, 2);
  const PolynomialFit coasted = fit_polynomial(s.time, s.displacement, coast, 2);
  averages.pull_acceleration = pulled.acceleration();
  averages.acceleration_error = pulled.acceleration_error();
  averages.pull_speed = pulled.c[1];
  averages.coast_deceleration = -coasted.acceleration();
  averages.deceleration_error = coasted.acceleration_error();
  averages.coast_speed = coasted.c[1];
  // x''' = 6 c_3 = d a / d t; over the speed it is -x''' / a_3, as the speed falls by a_3 per
  // second.
  const PolynomialFit cubic = fit_polynomial(s.time, s.displacement, coast, 3);
  const double a3 = averages.coast_deceleration;
  averages.slope = 6 * cubic.c[3] / a3;
  averages.slope_error = 6 * std::sqrt(cubic.covariance(3, 3)) / std::abs(a3);
}

void from_acceleration(const Trial& trial, const Phases& phases, const Span& pull,
                       const Span& coast, TrialAverages& averages) {
  const TrialSignals& s = trial.signals;
  const Mean offset = mean_and_error(s.acceleration, phases.held);
  const Mean pulled = mean_and_error(s.acceleration, pull),
             coasted = mean_and_error(s.acceleration, coast);
  averages.pull_acceleration = pulled.value - offset.value;
  averages.acceleration_error = std::hypot(pulled.error, offset.error);
  averages.coast_deceleration = offset.value - coasted.value;
  averages.deceleration_error = std::hypot(coasted.error, offset.error);
  const double top = averages.pull_acceleration * (phases.release - phases.start);
  averages.pull_speed = top / 2;
  averages.coast_speed = top - averages.coast_deceleration * (phases.stop - phases.release) / 2;
}

}  // namespace

double normal_force(const TrialSetup& setup) { return setup.mass * kStandardGravity; }

Resistance average_method(const TrialAverages& a) {
  const double inertia = a.setup.mass + a.setup.added_mass, string = a.setup.string_tension;
  Resistance r;
  r.pulled = a.pull_force - string - inertia * a.pull_acceleration;
  r.coasting = inertia * a.coast_deceleration - string;
  r.pulled_error = std::hypot(a.force_error, inertia * a.acceleration_error);
  r.coasting_error = inertia * a.deceleration_error;
  const double p = r.pulled_error * r.pulled_error, c = r.coasting_error * r.coasting_error;
  const double weight = p > 0 && c > 0 ? c / (p + c) : 0.5;  // of the pull
  r.mean = weight * r.pulled + (1 - weight) * r.coasting;
  r.mean_error = std::hypot(weight * r.pulled_error, (1 - weight) * r.coasting_error);
  return r;
}

Span used_of_pull(const Trial& trial, const Phases& phases) {
  return between(trial, phases.start + kAfterStart, phases.release - kAroundRelease);
}

Span settled_of_pull(const Trial& trial, const Phases& phases) {
  Span span = used_of_pull(trial, phases);
  if (trial.kind != TrialKind::kCrosswisePull) return span;
  const double half = (phases.start + phases.release) / 2;
  span.begin = std::max(span.begin, index_at(trial.signals.time, half));
  return span;
}

Span used_of_coast(const Trial& trial, const Phases& phases) {
  return between(trial, phases.release + kAroundRelease, phases.stop - kBeforeStop);
}

TrialAverages averages_of(const Trial& trial, const Phases& phases) {
  return averages_of(trial, phases, used_of_pull(trial, phases));
}

TrialAverages averages_of(const Trial& trial, const Phases& phases, const Span& pull) {
  const Span coast = used_of_coast(trial, phases);
  require_length(trial, pull, "II");
  require_length(trial, coast, "III");
  TrialAverages averages;
  averages.name = trial.name;
  averages.file = trial.file;
  averages.setup = trial.setup;
  const Mean force = mean_and_error(trial.signals.force, pull);
  averages.pull_force = force.value;
  averages.force_error = force.error;
  if (trial.signals.displacement.empty())
    from_acceleration(trial, phases, pull, coast, averages);
  else
    from_displacement(trial, pull, coast, averages);
  return averages;
}

}  // namespace gurney::calibration
