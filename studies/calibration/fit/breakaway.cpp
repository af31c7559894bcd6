#include "studies/calibration/fit/breakaway.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/calibration/fit/motion_law.h"
#include "studies/calibration/fit/slip_onset.h"
#include "studies/calibration/trials/average_method.h"
#include "studies/calibration/trials/trial_check.h"

namespace gurney::calibration {
namespace {

constexpr double kGathered = 0.5;                               // of the path
constexpr double kMoves = 0.05, kRolls = 0.15, kSteady = 0.25;  // of the path
constexpr std::size_t kRest = 9, kFewest = 24;
constexpr double kStands = 5e-3;          // [m/s]
constexpr double kShortest = 0.2;         // [s]
constexpr double kBefore = 0.3;           // of the onset, at least [s]
constexpr double kNewton = 3, kSure = 4;  // a factor; standard errors
constexpr double kLeastFriction = 0.02, kMaxFriction = 3, kMaxRolling = 0.5;

double mean(const std::vector<double>& series, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t i = from; i < to; ++i) sum += series[i];
  return sum / static_cast<double>(to - from);
}

/// First index of the last part of a record above a mark.
std::size_t beyond(const std::vector<double>& x, double mark) {
  std::size_t i = x.size();
  while (i > 0 && x[i - 1] > mark) --i;
  return i;
}

/// Force in motion less inertia, with its error [N].
struct Moving {
  double force, error;
  double at_end;  ///< force of the last 0.2 s
};

/// Mean acceleration is that between the middles of the first and the last 0.2 s.
Moving moving_force(const TrialSignals& s, const Span& moving, double inertia) {
  const auto index = [&](double time) {
    return static_cast<std::size_t>(std::ranges::lower_bound(s.time, time) - s.time.begin());
  };
  const Span first{moving.begin, index(s.time[moving.begin] + kShortest)};
  const Span last{index(s.time[moving.end - 1] - kShortest), moving.end};
  const PolynomialFit in = fit_polynomial(s.time, s.displacement, first, 2);
  const PolynomialFit out = fit_polynomial(s.time, s.displacement, last, 2);
  const double length = out.middle - in.middle;
  const double acceleration = (out.c[1] - in.c[1]) / length;
  const double acceleration_error =
      std::hypot(in.rate_error(in.middle), out.rate_error(out.middle)) / length;
  const PolynomialFit force =
      fit_polynomial(s.time, s.force, {index(in.middle), index(out.middle)}, 0);
  return {force.c[0] - inertia * acceleration,
          std::hypot(std::sqrt(force.covariance(0, 0)), inertia * acceleration_error),
          mean(s.force, last.begin, last.end)};
}

/// Where the onset is looked for. Motions from rest need the time T and less than 0.63 T for the
/// whole and a quarter of a path (x ~ t^2 or t^3), so that T is below 2.7 times the difference.
Span onset_window(const TrialSignals& s, double rest, double mark) {
  const std::size_t moved = beyond(s.displacement, rest + mark);
  const std::size_t quarter = beyond(s.displacement, rest + mark / 4);
  const double whole = 3 * (s.time[moved] - s.time[quarter]) + 2 * kBefore;
  return {static_cast<std::size_t>(std::ranges::lower_bound(s.time, s.time[moved] - whole) -
                                   s.time.begin()),
          moved};
}

/// Where it has 15 % of the speed that it has at `moved`, by differences over eight steps.
std::size_t gathers_from(const TrialSignals& s, std::size_t moved) {
  constexpr double kSlow = 0.15;
  constexpr std::size_t kHalf = 4;
  const auto step = [&](std::size_t i) {
    return s.displacement[i + kHalf] - s.displacement[i - kHalf];
  };
  std::size_t i = std::clamp(moved, kHalf, s.time.size() - 1 - kHalf);
  const double fast = step(i);
  while (i > kHalf && step(i) > kSlow * fast) --i;
  return i;
}

/// How force and motion contradict each other while it gathers speed; empty: nothing.
std::string wrong_motion(const TrialSignals& s, const Span& span, double inertia) {
  const auto law = motion_law(s, span, inertia);
  if (!law) return "";
  if (law->lag != 0)
    return fmt::format(
        "clock: the force is {:.2f} s {} the motion; force and motion must have one "
        "clock",
        std::abs(law->lag), law->lag > 0 ? "behind" : "ahead of");
  if (std::abs(law->scale - 1) > kSure * law->scale_error &&
      !(std::abs(std::log(law->scale)) < std::log(kNewton)))
    return fmt::format("it gathers speed {:.3g} times as fast as force and mass say, must be 1: {}",
                       law->scale, cause_of_ratio(law->scale, kNewton, !s.displacement.empty()));
  return "";
}

struct Ratio {
  double value, error;
};

/// Friction of the locked wheels from the force on the item over its weight.
Ratio friction_of(const Ratio& pull, const TrialSetup& setup) {
  if (setup.locked == LockedWheels::kAll) return pull;
  const bool front = setup.locked == LockedWheels::kFront;
  const double slope = (front ? 1 : -1) * setup.pull_height / setup.wheelbase;
  const double share = (front ? setup.front_share : 1 - setup.front_share) + slope * pull.value;
  const double rolling = setup.rolling_ratio;
  const double friction = (pull.value - (1 - share) * rolling) / share;
  return {friction, std::abs((1 - (friction - rolling) * slope) / share) * pull.error};
}

double turning_mass(const Trial& trial) {
  if (trial.kind != TrialKind::kLockedPull) return trial.setup.added_mass;
  return trial.setup.locked == LockedWheels::kAll ? 0 : trial.setup.added_mass / 2;
}

}  // namespace

std::optional<Breakaway> breakaway_of(const Trial& trial, TrialFault& fault) {
  const TrialSignals& s = trial.signals;
  const auto fail = [&](std::size_t at, const std::string& reason) {
    fault = {trial.file, line_of(trial, at), reason};
    return std::nullopt;
  };
  const std::size_t n = s.time.size();
  if (n < 2 * kFewest) return fail(0, fmt::format("only {} samples", n));
  const double rest = mean(s.displacement, 0, kRest);
  const double path = s.displacement.back() - rest;
  if (!(path > 50 * noise_of(s.displacement)) || !(path > 0))
    return fail(0, path < 0 ? "displacement falls while the force pulls: it must count in the "
                              "direction of the pull"
                            : "it never breaks away");
  const TrialSetup& setup = trial.setup;
  const bool locked = trial.kind == TrialKind::kLockedPull;
  const bool axle = locked && setup.locked != LockedWheels::kAll;
  const std::size_t moved = beyond(s.displacement, rest + kMoves * path);
  const std::size_t steady = axle ? beyond(s.displacement, rest + kSteady * path) : moved;
  std::size_t end = 0;
  while (end < n && s.displacement[end] < rest + (1 - kMoves) * path) ++end;
  const PolynomialFit begin = fit_polynomial(s.time, s.displacement, {0, kFewest}, 1);
  if (moved < kRest || std::abs(begin.c[1]) > kStands + 6 * begin.rate_error(begin.middle))
    return fail(0, "it does not stand still before it is pulled");
  const Span moving{steady, end};
  if (moving.size() < kFewest || s.time[end - 1] - s.time[steady] < 2 * kShortest)
    return fail(steady, fmt::format("it moves for less than {} s", 2 * kShortest));

  const double normal = normal_force(setup), inertia = setup.mass + turning_mass(trial);
  const Span gathering{gathers_from(s, moved), beyond(s.displacement, rest + kGathered * path)};
  if (const std::string wrong = wrong_motion(s, gathering, inertia); !wrong.empty())
    return fail(moved, wrong);
  const Moving motion = moving_force(s, moving, inertia);
  if (!(motion.at_end > motion.force / 2))
    return fail(end - 1, fmt::format("the force falls to {:.3g} N while it moves: is it kind = "
                                     "pull?",
                                     motion.at_end));
  const double mark = (locked ? kMoves : kRolls) * path;
  const auto onset =
      find_onset(s, onset_window(s, rest, mark), inertia, motion.force, motion.error, axle);
  if (!onset) return fail(0, "it does not stand still before it is pulled");
  const double string = setup.string_tension;
  const Ratio peak =
      friction_of({(onset->force - string) / normal, onset->force_error / normal}, setup);
  const Ratio kinetic =
      friction_of({(motion.force - string) / normal, motion.error / normal}, setup);
  const double least = locked ? kLeastFriction : 0, most = locked ? kMaxFriction : kMaxRolling;
  for (const double value : {peak.value, kinetic.value})
    if (!(value > least && value < most))
      return fail(moved, fmt::format("{} is {:.3g} at the start and {:.3g} in motion: must be > {} "
                                     "and < {}; are mass, force and units right, and is the kind?",
                                     locked ? "friction" : "force over weight", peak.value,
                                     kinetic.value, least, most));
  return Breakaway{peak.value, locked && !axle, kinetic.value,
                   peak.error, kinetic.error,   onset->time};
}

}  // namespace gurney::calibration
