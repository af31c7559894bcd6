#pragma once

#include "studies/explanation/facts.h"
#include "studies/results/run_facts.h"

namespace gurney::explanation {

/// The angle at which an item stands on its edge in a sample, towards where it tilts; NaN while it
/// tilts by less than 0.1 degrees, where that is no direction [rad].
double critical_tilt(const EquipmentModel& item, const Sample& sample);

/// @param until  overturning, or the end [s]
TiltMargin tilt_margin(const EquipmentModel& item, const std::vector<Sample>& history,
                       double until);

/// What holding an item takes and what its casters can hold, in a sample [N].
struct Grip {
  double demand = 0, grip = 0;
};
Grip grip_of(const study::RunFacts& facts, std::size_t item, const Sample& sample);

/// Until the item has overturned, or the end.
GripMargin grip_margin(const study::RunFacts& facts, std::size_t item,
                       const std::vector<Sample>& history, double until);

}  // namespace gurney::explanation
