#include "engine/simulate.h"

#include <algorithm>
#include <cmath>

#include "engine/recorder.h"
#include "engine/solver/equilibrium.h"
#include "engine/solver/mechanism.h"
#include "engine/solver/stepper.h"

namespace gurney {
namespace {

constexpr double kTimeTolerance = 1e-9;

double end_of_excitation(const Excitation& excitation, const std::vector<double>& breakpoints) {
  double end = excitation.floor.duration();
  for (double t : breakpoints) end = std::max(end, t);
  return end;
}

}  // namespace

Response simulate(const Scene& scene, const Excitation& excitation,
                  const SimulationSettings& settings) {
  validate(scene.item);
  validate(settings);
  const Mechanism mechanism(scene, excitation);
  State state = mechanism.placed(scene.initial);
  settle(mechanism, scene, excitation, state);
  mechanism.set_in_motion(scene.initial, state);

  Stepper stepper(mechanism, excitation.floor, settings);
  Recorder recorder(scene, mechanism, state);
  const Stepper::Observer observer = [&](const Stepper::Step& step) { recorder.observe(step); };

  std::vector<double> breakpoints = mechanism.loads.breakpoints();
  const double excitation_end = end_of_excitation(excitation, breakpoints);
  if (!excitation.floor.at_rest()) breakpoints.push_back(excitation.floor.duration());
  std::sort(breakpoints.begin(), breakpoints.end());
  std::size_t next_break = 0;

  const double limit =
      settings.duration > 0 ? settings.duration : excitation_end + settings.settle_time;
  const bool keep = settings.history_step > 0;
  const long stride =
      std::max(1L, std::lround((keep ? settings.history_step : 0.1) / settings.time_step));
  recorder.sample(state, stepper.account(), keep);

  Response response;
  response.outcome = settings.duration > 0 ? Outcome::kStopped : Outcome::kStillMoving;
  double resting_since = 0;
  for (long n = 1; state.time < limit - kTimeTolerance; ++n) {
    const double grid = std::min(static_cast<double>(n) * settings.time_step, limit);
    std::optional<std::string> cause;
    while (!cause && state.time < grid - kTimeTolerance) {
      while (next_break < breakpoints.size() &&
             breakpoints[next_break] <= state.time + kTimeTolerance) {
        stepper.account().damper_loss +=
            mechanism.loads.release(breakpoints[next_break], state.loads);
        stepper.forget_acceleration();
        ++next_break;
      }
      double target = grid;
      if (next_break < breakpoints.size() && breakpoints[next_break] < grid - kTimeTolerance)
        target = breakpoints[next_break];
      cause = stepper.advance(state, target, observer);
    }
    if (cause) {
      response.outcome = Outcome::kDiverged;
      response.cause = *cause;
      break;
    }
    if (n % stride == 0) recorder.sample(state, stepper.account(), keep);
    if (recorder.tilt() > settings.overturn_tilt) {
      response.outcome = Outcome::kOverturned;
      recorder.demands().time_of_overturning = state.time;
      break;
    }
    if (recorder.speed() > settings.rest_speed) resting_since = state.time;
    if (settings.duration == 0 && state.time >= excitation_end &&
        state.time - resting_since >= settings.rest_hold) {
      response.outcome = Outcome::kRested;
      break;
    }
  }
  response.quality = stepper.quality();
  recorder.finish(state, stepper.account(), response);
  return response;
}

}  // namespace gurney
