#include "engine/record/tether_log.h"

#include <algorithm>

namespace gurney {

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
      const double tension = tethers.tension(i, to);
      outcome.peak_tension = std::max(outcome.peak_tension, tension);
      if (tension > 0 && outcome.time_taut < 0) outcome.time_taut = time;
      if (broken(to)) outcome.time_broken = time;
    }
  }
}

}  // namespace gurney
