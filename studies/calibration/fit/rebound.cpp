#include "studies/calibration/fit/rebound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/run/simulate.h"
#include "studies/calibration/fit/trial_model.h"
#include "studies/calibration/trials/polynomial_fit.h"

namespace gurney::calibration {
namespace {

constexpr double kWindow = 0.25, kAway = 0.03;   // [s]
constexpr double kSlowest = 0.02, kFastest = 5;  // [m/s]
constexpr double kMaxSlowing = 1;                // [m/s2]
constexpr std::size_t kFewest = 12;

constexpr double kBefore = 0.3, kAfter = 0.4;  // the wall [s]
constexpr double kTimeStep = 1.0 / 240;        // at most [s]
constexpr double kAgrees = 1e-4, kLeast = 0.01;
constexpr int kMaxRuns = 8;
constexpr double kWallSize = 20, kWallDepth = 0.1;  // [m]

class WallRun {
 public:
  WallRun(const Trial& trial, const Rebound& rebound) {
    scene_ = scene_of(item_of(trial.setup));
    scene_.items[0].model.material = "item";
    scene_.items[0].initial.velocity = {rebound.approach + rebound.slowing * kBefore, 0, 0};
    const double gap = (rebound.approach + rebound.slowing * kBefore / 2) * kBefore;
    double front = 0;
    for (const BodyShape& box : scene_.items[0].model.shape)
      front = std::max(front, box.center.x() + box.size.x() / 2);
    RoomShape wall;
    wall.name = wall.material = "wall";
    wall.position = {front + gap + kWallDepth / 2, 0, kWallSize / 2};
    wall.shape = RoomBox{{kWallDepth, kWallSize, kWallSize}};
    scene_.room = {wall};
    const std::vector<double>& t = trial.signals.time;
    const double step = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
    settings_.time_step = step / std::max(1.0, std::ceil(step / kTimeStep - 1e-6));
    settings_.history_step = step;
    settings_.duration = kBefore + kAfter;
  }

  double ratio(double restitution) {
    ContactConstants contact;
    contact.restitution = restitution;
    scene_.pairs = {{"item", "wall", contact}, {"item", "", contact}};
    Trial trial;
    trial.kind = TrialKind::kImpact;
    const Response response = simulate(scene_, {}, settings_);
    for (const Sample& sample : response.items[0].history) {
      trial.signals.time.push_back(sample.time);
      trial.signals.displacement.push_back(sample.displacement.x());
    }
    try {
      return rebound_of(trial).restitution;
    } catch (const UnusableTrial& error) {
      throw Error("the engine's run of the impact: " + error.fault.reason);
    }
  }

 private:
  Scene scene_;
  SimulationSettings settings_;
};

}  // namespace

Rebound rebound_of(const Trial& trial) {
  const std::vector<double>&t = trial.signals.time, &x = trial.signals.displacement;
  const auto top = static_cast<std::size_t>(std::ranges::max_element(x) - x.begin());
  const auto index = [&](double time) { return index_at(t, time); };
  const Span before{index(t[top] - kWindow), index(t[top] - kAway)};
  const Span after{index(t[top] + kAway), index(t[top] + kWindow)};
  if (before.size() < kFewest || after.size() < kFewest)
    refuse(trial, top, fmt::format("{} s before and after the impact are needed", kWindow));
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
    refuse(trial, top,
           fmt::format("it meets the wall with {:.3g} m/s: must be > {} and < {} m/s; are "
                       "the units right?",
                       result.approach, kSlowest, kFastest));
  if (!(result.slowing < kMaxSlowing + 4 * in.acceleration_error()))
    refuse(trial, top,
           fmt::format("it slows down by {:.3g} m/s2 before it meets the wall: must be < "
                       "{} m/s2; are the units right?",
                       result.slowing, kMaxSlowing));
  if (!(result.restitution > 0 && result.restitution <= 1))
    refuse(trial, top,
           fmt::format("it leaves with {:.3g} m/s after {:.3g} m/s: restitution must be "
                       "in (0, 1]",
                       result.leaving, result.approach));
  if (trial.setup.item.empty()) return result;
  try {
    const ContactRestitution contact = contact_restitution(trial, result);
    result.restitution = contact.value;
    result.error *= contact.slope;
  } catch (const Error& error) {
    refuse(trial, top, error.what());
  }
  return result;
}

ContactRestitution contact_restitution(const Trial& trial, const Rebound& rebound) {
  WallRun run(trial, rebound);
  const double wanted = rebound.leaving / rebound.approach;
  double before = std::clamp(wanted, kLeast, 1.0), ratio_before = run.ratio(before);
  double value = std::clamp(before + wanted - ratio_before, kLeast, 1.0), slope = 1;
  for (int i = 1; i < kMaxRuns && value != before; ++i) {
    const double ratio = run.ratio(value);
    slope = (value - before) / (ratio - ratio_before);
    if (std::abs(ratio - wanted) < kAgrees) return {value, slope};
    before = value;
    ratio_before = ratio;
    value = std::clamp(value + slope * (wanted - ratio), kLeast, 1.0);
  }
  if (std::abs(ratio_before - wanted) < kAgrees) return {value, slope};
  throw Error(
      fmt::format("no restitution in {} to 1 makes the engine's item leave with {:.3g} of "
                  "its speed",
                  kLeast, wanted));
}

}  // namespace gurney::calibration
