#pragma once

#include <string>
#include <vector>

#include "equipment/catalogue/caster_type.h"

namespace gurney::equipment {

/// What is allowed but hardly meant: a chassis lighter or heavier than equipment can be, a centre
/// of mass outside its shape, a caster that swivels without trail.
std::vector<std::string> implausible(const EquipmentModel& item);

/// Likewise: a contact patch wider than its wheel, a wheel whose mass lies beyond its rim.
std::vector<std::string> implausible(const CasterType& caster);

}  // namespace gurney::equipment
