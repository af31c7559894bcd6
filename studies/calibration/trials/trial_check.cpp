#include "studies/calibration/trials/trial_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/units.h"

namespace gurney::calibration {
namespace {

constexpr double kGap = 1.5, kIrregular = 0.1, kDrift = 0.005;  // of a step
constexpr double kLongestStep = 0.2, kShortestStep = 1e-5;      // [s]
constexpr double kBalance = 0.15;
constexpr double kClocks = 0.05;  // [s]
constexpr double kFarOff = 1.2;   // a factor, from that of a unit

void check_filled(const Trial& trial) {
  const TrialSignals& s = trial.signals;
  const std::array<std::pair<const char*, const std::vector<double>*>, 6> all = {
      {{"time", &s.time},
       {"force", &s.force},
       {"displacement", &s.displacement},
       {"lateral displacement", &s.lateral},
       {"acceleration", &s.acceleration},
       {"yaw", &s.yaw}}};
  for (std::size_t i = 0; i < s.time.size(); ++i)
    for (const auto& [name, series] : all)
      if (!series->empty() && !std::isfinite((*series)[i]))
        refuse(trial, i, fmt::format("gap: {} is empty", name));
}

void check_clock(const Trial& trial) {
  const std::vector<double>& t = trial.signals.time;
  if (t.size() < 3) return;
  std::vector<double> steps;
  for (std::size_t i = 1; i < t.size(); ++i) {
    steps.push_back(t[i] - t[i - 1]);
    if (!(steps.back() > 0))
      refuse(trial, i, fmt::format("clock: time goes from {} to {} s", t[i - 1], t[i]));
  }
  std::vector<double> sorted = steps;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2));
  const double step = sorted[sorted.size() / 2];
  if (step > kLongestStep || step < kShortestStep)
    refuse(trial, 0,
           fmt::format("units: a step of time is {:.4g} s: is the time in ms in a column "
                       "of s, or the reverse?",
                       step));
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] > kGap * step)
      refuse(trial, i + 1,
             fmt::format("gap: {:.4g} s without a sample, the step is {:.4g} s", steps[i], step));
    if (std::abs(steps[i] - step) > kIrregular * step)
      refuse(trial, i + 1,
             fmt::format("clock: a step of {:.4g} s among steps of {:.4g} s", steps[i], step));
  }
  const double mean = (t.back() - t.front()) / static_cast<double>(steps.size());
  const std::size_t tenth = steps.size() / 10;
  for (std::size_t i = 0; tenth >= 10 && i + tenth < t.size(); i += tenth) {
    const double local = (t[i + tenth] - t[i]) / static_cast<double>(tenth);
    if (std::abs(local / mean - 1) > kDrift)
      refuse(trial, i,
             fmt::format("clock drift: the step is {:.5g} s here and {:.5g} s "
                         "on average",
                         local, mean));
  }
}

void check_force(const Trial& trial) {
  const std::vector<double>& force = trial.signals.force;
  if (force.empty()) return;
  const std::vector<double> smooth = median_of_five(force);
  const double allowed = 6 * noise_of(force) + 0.01 * std::ranges::max(smooth);
  for (std::size_t i = 0; i < smooth.size(); ++i)
    if (smooth[i] < -std::max(allowed, 0.0))
      refuse(trial, i, fmt::format("negative force: {:.4g} N; a cable only pulls", smooth[i]));
}

/// Mass that would explain the motion; empty where none does.
std::string mass_in_question(const TrialSetup& setup, double ratio) {
  const double mass = (setup.mass + setup.added_mass) / ratio - setup.added_mass;
  if (!(mass > 0)) return "";
  return fmt::format("is the mass of {:.4g} kg right ({:.4g} kg would give 1)? Or: ", setup.mass,
                     mass);
}

}  // namespace

std::string cause_of_ratio(double ratio, double within, bool of_displacement) {
  struct Cause {
    double ratio;
    const char *displacement, *acceleration;  ///< by what was measured; null: cannot be
  };
  constexpr std::array kCauses = {
      Cause{1e3,
            "is the displacement a thousand times too large, such as mm in a column of m, or the "
            "force in kN in a column of N?",
            "is the acceleration a thousand times too large, such as mm/s2 in a column of m/s2, or "
            "the force in kN in a column of N?"},
      Cause{1e-3,
            "is the displacement a thousandth, such as m in a column of mm, or the force in N "
            "in a column of kN?",
            "is the acceleration a thousandth, or the force in N in a column of kN?"},
      Cause{1e-6, "is the time in ms in a column of s?", nullptr},
      Cause{1e6, "is the time in s in a column of ms?", nullptr},
      Cause{kStandardGravity, "is the force in kg in a column of N?",
            "is the acceleration in m/s2 in a column of g, or the force in kg in a column of N?"},
      Cause{1 / kStandardGravity, "is the force in N in a column of kg?",
            "is the acceleration in g in a column of m/s2, or the force in N in a column of kg?"}};
  for (const Cause& cause : kCauses) {
    const char* const text = of_displacement ? cause.displacement : cause.acceleration;
    if (text != nullptr && std::abs(std::log(ratio / cause.ratio)) < std::log(within))
      return std::string("units: ") + text;
  }
  return "mass, force or clock are wrong, or the phases were not free of other forces";
}

void check_samples(const Trial& trial) {
  check_filled(trial);
  check_clock(trial);
  check_force(trial);
}

void check_averages(const TrialAverages& a, bool of_displacement) {
  const auto fail = [&](std::string reason) {
    throw UnusableTrial({a.file, a.line, std::move(reason)});
  };
  const double inertia = a.setup.mass + a.setup.added_mass;
  const double ratio = inertia * (a.pull_acceleration + a.coast_deceleration) / a.pull_force;
  const std::string balance =
      fmt::format("(M + J)(a_2 + a_3) is {:.4g} of the force, must be 1: ", ratio);
  if (!(ratio > 0)) fail(balance + "it does not slow down in phase III");
  if (!(std::abs(std::log(ratio)) < kBalance))
    fail(balance + mass_in_question(a.setup, ratio) +
         cause_of_ratio(ratio, kFarOff, of_displacement));
  const Resistance r = average_method(a);
  if (!(r.pulled > 0) || !(r.coasting > 0))
    fail(
        fmt::format("rolling resistance is {:.3g} N pulled and {:.3g} N coasting: must be "
                    "> 0; are mass, force and string tension right?",
                    r.pulled, r.coasting));
}

void check_phases(const Trial& trial, const Phases& phases) {
  const TrialSignals& s = trial.signals;
  if (s.displacement.empty()) return;
  const PolynomialFit pull =
      fit_polynomial(s.time, s.displacement, settled_of_pull(trial, phases), 2);
  const PolynomialFit coast =
      fit_polynomial(s.time, s.displacement, used_of_coast(trial, phases), 2);
  const double bend = pull.acceleration() - coast.acceleration();
  const double meet =
      phases.release + (coast.rate(phases.release) - pull.rate(phases.release)) / bend;
  const double error =
      std::hypot(pull.rate_error(phases.release), coast.rate_error(phases.release)) / bend;
  if (std::abs(meet - phases.release) > kClocks + 4 * error)
    refuse(trial, phases.coasting.begin,
           fmt::format("clock: the force falls at {:.3f} s, but the motion says {:.3f} s; "
                       "force and motion must have one clock",
                       phases.release, meet));
  if (!trial.setup.drop_mass || phases.held.size() == 0) return;
  const double held = mean_of(s.force, phases.held);
  const double weight = *trial.setup.drop_mass * kStandardGravity;
  if (!(std::abs(std::log(held / weight)) < kBalance))
    refuse(trial, 0,
           fmt::format("the force in phase I is {:.4g} N, but the drop weight weighs "
                       "{:.4g} N",
                       held, weight));
}

}  // namespace gurney::calibration
