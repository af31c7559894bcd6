#pragma once

#include <string>
#include <vector>

#include "studies/units/unit_system.h"

namespace gurney::report {

/// "a, b and c"
std::string listed(const std::vector<std::string>& names);

/// "towards +x" or "between +x and +y", by the nearest of eight directions, with the angle.
/// @param direction  from the floor's x axis [rad]
std::string towards(double direction, const study::UnitSystem& units);

}  // namespace gurney::report
