#include "engine/scene/settings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/scene/problems.h"

namespace gurney {
namespace {

constexpr double kLoosestTolerance = 0.1;

}  // namespace

void lengthen_steps(double factor, SimulationSettings& settings) {
  settings.time_step *= factor;
  settings.tolerance = std::min(factor * factor * factor * settings.tolerance, kLoosestTolerance);
}

void validate(const SimulationSettings& settings) {
  Problems problems;
  problems.set_prefix("settings: ");
  const auto check = [&](bool holds, const char* name, double value, const char* allowed) {
    problems.check(holds, name, value, allowed);
  };
  const SimulationSettings& s = settings;
  check(s.time_step > 0 && s.time_step <= 0.02, "time_step", s.time_step, "> 0 and <= 0.02 s");
  check(s.tolerance >= 0 && s.tolerance <= kLoosestTolerance, "tolerance", s.tolerance,
        "in [0, 0.1]");
  check(s.residual > 0 && s.residual <= 1e-3, "residual", s.residual, "> 0 and <= 0.001");
  check(s.max_newton_iterations >= 4 && s.max_newton_iterations <= 1000, "max_newton_iterations",
        s.max_newton_iterations, "in 4..1000");
  check(s.max_subdivisions >= 0 && s.max_subdivisions <= 20, "max_subdivisions", s.max_subdivisions,
        "in 0..20");
  check(s.settle_time >= 0 && std::isfinite(s.settle_time), "settle_time", s.settle_time,
        ">= 0 s and finite");
  check(s.duration >= 0 && std::isfinite(s.duration), "duration", s.duration, ">= 0 s and finite");
  check(s.rest_speed > 0 && std::isfinite(s.rest_speed), "rest_speed", s.rest_speed,
        "> 0 m/s and finite");
  check(s.rest_hold > 0 && std::isfinite(s.rest_hold), "rest_hold", s.rest_hold,
        "> 0 s and finite");
  check(s.overturn_tilt > 0 && s.overturn_tilt < std::numbers::pi / 2, "overturn_tilt",
        s.overturn_tilt, "> 0 and < pi/2 rad");
  check(s.history_step >= 0 && std::isfinite(s.history_step), "history_step", s.history_step,
        ">= 0 s and finite");
  problems.finish();
}

}  // namespace gurney
