#pragma once

#include <string>
#include <vector>

#include "engine/scene/equipment_model.h"

namespace gurney::explanation {

/// "front left" by the mount against the middle of all mounts (x to the front, y to the left).
std::string place_of(const EquipmentModel& item, std::size_t caster);

/// The caster's name; with its place where the name does not state it.
std::string caster_words(const EquipmentModel& item, std::size_t caster);

}  // namespace gurney::explanation
