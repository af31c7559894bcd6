#include "studies/calibration/breakaway.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/trials/average_method.h"

namespace gurney {
namespace {

constexpr double kMoves = 0.05;  // of the path
constexpr std::size_t kRest = 9, kFewest = 24;
constexpr double kShortest = 0.2;  // [s]

double mean(const std::vector<double>& series, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t i = from; i < to; ++i) sum += series[i];
  return sum / static_cast<double>(to - from);
}

struct Peak {
  double force = 0, error = 0;
};

/// Largest force less inertia in windows that begin before `moved`.
Peak peak_resistance(const TrialSignals& s, double inertia, double window, std::size_t moved) {
  Peak peak;
  for (std::size_t begin = 0; begin < moved; begin += 2) {
    const auto end = static_cast<std::size_t>(
        std::ranges::upper_bound(s.time, s.time[begin] + window) - s.time.begin());
    if (end >= s.time.size() || end < begin + 5) continue;
    const Span span{begin, end};
    const PolynomialFit motion = fit_polynomial(s.time, s.displacement, span, 2);
    const double force = mean(s.force, begin, end) - inertia * motion.acceleration();
    if (force <= peak.force) continue;
    const double noise = noise_of(s.force) / std::sqrt(static_cast<double>(span.size()));
    peak = {force, std::hypot(noise, inertia * motion.acceleration_error())};
  }
  return peak;
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
  const double noise = noise_of(s.displacement);
  if (!(path > 50 * noise) || !(path > 0)) return fail(0, "it never breaks away");
  std::size_t moved = n, end = 0;
  while (moved > 0 && s.displacement[moved - 1] > rest + kMoves * path) --moved;
  while (end < n && s.displacement[end] < rest + (1 - kMoves) * path) ++end;
  if (moved < kRest) return fail(0, "it does not stand still before it is pulled");
  const Span moving{moved, end};
  if (moving.size() < kFewest || s.time[end - 1] - s.time[moved] < 2 * kShortest)
    return fail(moved, fmt::format("it moves for less than {} s", 2 * kShortest));

  const TrialSetup& setup = trial.setup;
  const double normal = normal_force(setup);
  const bool locked = trial.kind == TrialKind::kLockedPull;
  const double inertia = setup.mass + (locked ? 0 : setup.added_mass);
  const Peak peak = peak_resistance(s, inertia, locked ? kShortest : 2 * kShortest, moved);
  // Mean acceleration between the middles of the first and the last 0.2 s.
  const auto index = [&](double time) {
    return static_cast<std::size_t>(std::ranges::lower_bound(s.time, time) - s.time.begin());
  };
  const Span first{moved, index(s.time[moved] + kShortest)};
  const Span last{index(s.time[end - 1] - kShortest), end};
  const PolynomialFit in = fit_polynomial(s.time, s.displacement, first, 2);
  const PolynomialFit out = fit_polynomial(s.time, s.displacement, last, 2);
  const double length = out.middle - in.middle;
  const double acceleration = (out.c[1] - in.c[1]) / length;
  const double acceleration_error =
      std::hypot(in.rate_error(in.middle), out.rate_error(out.middle)) / length;
  const PolynomialFit force =
      fit_polynomial(s.time, s.force, {index(in.middle), index(out.middle)}, 0);
  const double at_end = mean(s.force, last.begin, last.end);
  if (!(at_end > force.c[0] / 2))
    return fail(last.begin, fmt::format("the force falls to {:.3g} N while it moves: is it kind = "
                                        "pull?",
                                        at_end));
  Breakaway result;
  result.peak = (peak.force - setup.string_tension) / normal;
  result.peak_error = peak.error / normal;
  result.moving = (force.c[0] - setup.string_tension - inertia * acceleration) / normal;
  result.moving_error =
      std::hypot(std::sqrt(force.covariance(0, 0)), inertia * acceleration_error) / normal;
  result.moved_at = s.time[moved];
  if (!(result.peak > 0) || !(result.moving > 0))
    return fail(moved, fmt::format("force over weight is {:.3g} at its peak and {:.3g} in motion: "
                                   "must be > 0; are mass, force and units right?",
                                   result.peak, result.moving));
  return result;
}

}  // namespace gurney
