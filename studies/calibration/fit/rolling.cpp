#include "studies/calibration/fit/rolling.h"

namespace gurney::calibration {

double RollingTrial::ratio() const { return resistance.mean / normal_force(averages.setup); }
double RollingTrial::error() const { return resistance.mean_error / normal_force(averages.setup); }

TrialValue value_of(const RollingTrial& trial) {
  return {ConstantKind::kRolling, trial.averages.name, trial.averages.setup, trial.ratio(),
          trial.error()};
}

}  // namespace gurney::calibration
