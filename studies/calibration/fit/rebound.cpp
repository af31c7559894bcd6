#include "studies/calibration/fit/rebound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "studies/calibration/fit/impact_model.h"
#include "studies/calibration/trials/polynomial_fit.h"

namespace gurney::calibration {
namespace {

constexpr double kWindow = 0.25, kAway = 0.03;   // [s]
constexpr double kSlowest = 0.02, kFastest = 5;  // [m/s]
constexpr double kMaxSlowing = 1;                // [m/s2]
constexpr std::size_t kFewest = 12;

}  // namespace

std::optional<Rebound> rebound_of(const Trial& trial, TrialFault& fault) {
  const std::vector<double>&t = trial.signals.time, &x = trial.signals.displacement;
  const auto fail = [&](std::size_t at, const std::string& reason) {
    fault = {trial.file, line_of(trial, at), reason};
    return std::nullopt;
  };
  const auto top = static_cast<std::size_t>(std::ranges::max_element(x) - x.begin());
  const auto index = [&](double time) {
    return static_cast<std::size_t>(std::ranges::lower_bound(t, time) - t.begin());
  };
  const Span before{index(t[top] - kWindow), index(t[top] - kAway)};
  const Span after{index(t[top] + kAway), index(t[top] + kWindow)};
  if (before.size() < kFewest || after.size() < kFewest)
    return fail(top, fmt::format("{} s before and after the impact are needed", kWindow));
  const PolynomialFit in = fit_polynomial(t, x, before, 2), out = fit_polynomial(t, x, after, 2);
  Rebound result;
  result.time = t[top];
  result.approach = in.rate(t[top]);
  result.slowing = -in.acceleration();
  result.leaving = -out.rate(t[top]);
  result.restitution = result.leaving / result.approach;
  result.error = result.restitution * std::hypot(in.rate_error(t[top]) / result.approach,
                                                 out.rate_error(t[top]) / result.leaving);
  if (!(result.approach > kSlowest && result.approach < kFastest))
    return fail(top,
                fmt::format("it meets the wall with {:.3g} m/s: must be > {} and < {} m/s; are "
                            "the units right?",
                            result.approach, kSlowest, kFastest));
  if (!(result.slowing < kMaxSlowing + 4 * in.acceleration_error()))
    return fail(top, fmt::format("it slows down by {:.3g} m/s2 before it meets the wall: must be < "
                                 "{} m/s2; are the units right?",
                                 result.slowing, kMaxSlowing));
  if (!(result.restitution > 0 && result.restitution <= 1))
    return fail(top, fmt::format("it leaves with {:.3g} m/s after {:.3g} m/s: restitution must be "
                                 "in (0, 1]",
                                 result.leaving, result.approach));
  if (trial.setup.item.empty()) return result;
  try {
    const ContactRestitution contact = contact_restitution(trial, result);
    result.restitution = contact.value;
    result.error *= contact.slope;
  } catch (const Error& error) {
    return fail(top, error.what());
  }
  return result;
}

}  // namespace gurney::calibration
