#pragma once

#include "engine/scene/equipment_model.h"
#include "studies/calibration/trials/trial.h"

namespace gurney::calibration {

/// The item of a trial from the catalogue, with its payload, casters, floor and headings. A floor
/// that the catalogue does not know has the factor 1.
/// @throws Error where the catalogue does not know the item, its payload or the caster, it has no
///         casters, or it does not weigh what the trial says within 2 % (where it says so)
EquipmentModel item_of(const TrialSetup& setup);

}  // namespace gurney::calibration
