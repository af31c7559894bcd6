#include "engine/scene/settings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/error_text.h"

namespace gurney {
namespace {

TEST(Settings, DefaultsAreValid) { EXPECT_NO_THROW(validate(SimulationSettings{})); }

TEST(Settings, NamesEverySettingOutsideItsRange) {
  SimulationSettings settings;
  settings.time_step = std::nan("");
  settings.tolerance = 0.2;
  settings.residual = 0;
  settings.max_newton_iterations = 3;
  settings.max_subdivisions = 21;
  settings.settle_time = -1;
  settings.duration = INFINITY;
  settings.rest_speed = 0;
  settings.rest_hold = 0;
  settings.overturn_tilt = 2;
  settings.history_step = -0.1;
  EXPECT_EQ(error_text([&] { validate(settings); }),
            "settings: time_step = nan: must be > 0 and <= 0.02 s\n"
            "settings: tolerance = 0.2: must be in [0, 0.1]\n"
            "settings: residual = 0: must be > 0 and <= 0.001\n"
            "settings: max_newton_iterations = 3: must be in 4..1000\n"
            "settings: max_subdivisions = 21: must be in 0..20\n"
            "settings: settle_time = -1: must be >= 0 s and finite\n"
            "settings: duration = inf: must be >= 0 s and finite\n"
            "settings: rest_speed = 0: must be > 0 m/s and finite\n"
            "settings: rest_hold = 0: must be > 0 s and finite\n"
            "settings: overturn_tilt = 2: must be > 0 and < pi/2 rad\n"
            "settings: history_step = -0.1: must be >= 0 s and finite");
}

/// The error of a step grows with its cube: an eighth of it is that of half the step.
TEST(Settings, ShorterStepsTightenTheTolerance) {
  SimulationSettings settings{.time_step = 0.004, .tolerance = 0.08};
  lengthen_steps(0.5, settings);
  EXPECT_EQ(settings.time_step, 0.002);
  EXPECT_DOUBLE_EQ(settings.tolerance, 0.01);
  lengthen_steps(4, settings);
  EXPECT_NO_THROW(validate(settings));
}

}  // namespace
}  // namespace gurney
