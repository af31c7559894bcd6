#pragma once

#include <string>
#include <vector>

#include "engine/response/settled.h"
#include "engine/scene/scene.h"

namespace gurney::study {

/// Begins the warning of a run whose repetition at half the time step failed.
inline constexpr const char* kHalfStepFailed = "the repetition with half the time step failed: ";

/// How the items of a scene are called: as placed, or, without a name there, as their models.
std::vector<std::string> item_names(const Scene& scene);

std::vector<std::string> caster_names(const EquipmentModel& model);
std::vector<std::string> point_names(const EquipmentModel& model);

/// The wheel or marked point that has a number; empty: the item.
std::string part_of(const DemandNumber& number, const EquipmentModel& model);

}  // namespace gurney::study
