#include "engine/record/tether_log.h"

#include <algorithm>

namespace gurney {
namespace {

/// One that was whole at the begin of a step, at its end.
void note(double tension, bool broken, double time, TetherOutcome& outcome) {
  outcome.peak_tension = std::max(outcome.peak_tension, tension);
  if (tension > 0 && outcome.time_taut < 0) outcome.time_taut = time;
  if (broken) outcome.time_broken = time;
}

}  // namespace

void TetherLog::observe(const Stepper::Step& step) {
  const double time = step.time + step.duration;
  for (std::size_t item : step.island->items) {
    const Tethers& tethers = assembly_.items[item].tethers;
    const State& from = step.from->items[item];
    const State& to = step.to->items[item];
    for (std::size_t i = 0; i < tethers.indices().size(); ++i) {
      TetherOutcome& outcome = outcomes_[tethers.indices()[i]];
      const auto broken = [i](const State& s) { return (s.broken_tethers >> i & 1u) != 0; };
      if (broken(from)) continue;
      note(tethers.tension(i, to), broken(to), time, outcome);
    }
  }
  for (std::size_t j : step.island->joints) {
    const auto tether = assembly_.joints[j].tether();
    const JointState& to = step.to->joints[j];
    if (tether && step.from->joints[j].latched)
      note(to.wind, !to.latched, time, outcomes_[*tether]);
  }
}

}  // namespace gurney
