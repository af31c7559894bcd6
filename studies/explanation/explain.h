#pragma once

#include <cstddef>
#include <limits>

#include "studies/explanation/facts.h"
#include "studies/results/run_facts.h"

namespace gurney::explanation {

/// Slower impacts are a touch [m/s].
inline constexpr double kHit = 0.05;
/// Less of the critical tilt is no rocking to speak of [-].
inline constexpr double kRocks = 0.5;

/// When the item had overturned; infinite: it did not [s].
double until_overturned(const ItemResponse& item);

/// @param response  of the scene, with histories
Explanation explain(const study::RunFacts& facts, const Response& response);

/// The worst that happened to an item.
Finding finding_of(const Response& response, std::size_t item, double tilt_ratio);

/// The hardest impact of an item with anything but the floor up to a time; none: null.
const Impact* hardest_impact(const Response& response, std::size_t item,
                             double until = std::numeric_limits<double>::infinity());

/// Settings whose histories resolve single steps, as far as memory allows: no more than 40,000
/// samples of all items together, unless more are asked for. The samples asked for are among them.
/// The spacing has no influence on the results.
RunOptions finely_stored(RunOptions settings, const FloorMotion& floor, std::size_t items);

/// The angle at which an item stands on its edge in a sample, towards where it tilts; NaN while it
/// tilts by less than 0.1 degrees, where that is no direction [rad].
double critical_tilt(const EquipmentModel& item, const Sample& sample);

/// @param until  overturning, or the end [s]
TiltMargin tilt_margin(const EquipmentModel& item, const std::vector<Sample>& history,
                       double until);

/// Force that holds an item and capacity of its casters, in a sample [N].
struct Grip {
  double demand = 0, grip = 0;
};
/// @param mass  of the item with what it carries [kg]
Grip grip_of(const study::RunFacts& facts, std::size_t item, double mass, const Sample& sample);

/// Until the item has overturned, or the end.
GripMargin grip_margin(const study::RunFacts& facts, std::size_t item, double mass,
                       const std::vector<Sample>& history, double until);

}  // namespace gurney::explanation
