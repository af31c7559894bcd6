#include "studies/calibration/breakaway.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/trials/average_method.h"

namespace gurney {
namespace {

constexpr double kMoves = 0.05;  // of the path
constexpr std::size_t kMean = 9, kFewest = 24;
constexpr double kShortest = 0.2;  // [s]

double mean(const std::vector<double>& series, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t i = from; i < to; ++i) sum += series[i];
  return sum / static_cast<double>(to - from);
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
  const double rest = mean(s.displacement, 0, kMean);
  const double path = s.displacement.back() - rest;
  const double noise = noise_of(s.displacement);
  if (!(path > 50 * noise) || !(path > 0)) return fail(0, "it never breaks away");
  std::size_t moved = n, end = 0;
  while (moved > 0 && s.displacement[moved - 1] > rest + kMoves * path) --moved;
  while (end < n && s.displacement[end] < rest + (1 - kMoves) * path) ++end;
  if (moved < kMean) return fail(0, "it does not stand still before it is pulled");
  const Span moving{moved, end};
  if (moving.size() < kFewest || s.time[end - 1] - s.time[moved] < kShortest)
    return fail(moved, fmt::format("it moves for less than {} s", kShortest));

  const TrialSetup& setup = trial.setup;
  const double normal = normal_force(setup);
  const bool locked = trial.kind == TrialKind::kLockedPull;
  const double inertia = setup.mass + (locked ? 0 : setup.added_mass);
  double peak = 0;
  for (std::size_t i = 0; i + kMean <= moved; ++i)
    peak = std::max(peak, mean(s.force, i, i + kMean));
  const PolynomialFit motion = fit_polynomial(s.time, s.displacement, moving, 2);
  const PolynomialFit force = fit_polynomial(s.time, s.force, moving, 0);
  Breakaway result;
  result.peak = (peak - setup.string_tension) / normal;
  result.peak_error = noise_of(s.force) / std::sqrt(static_cast<double>(kMean)) / normal;
  result.moving = (force.c[0] - setup.string_tension - inertia * motion.acceleration()) / normal;
  result.moving_error =
      std::hypot(std::sqrt(force.covariance(0, 0)), inertia * motion.acceleration_error()) / normal;
  result.moved_at = s.time[moved];
  if (!(result.peak > 0) || !(result.moving > 0))
    return fail(moved, fmt::format("force over weight is {:.3g} at its peak and {:.3g} in motion: "
                                   "must be > 0; are mass, force and units right?",
                                   result.peak, result.moving));
  return result;
}

}  // namespace gurney
