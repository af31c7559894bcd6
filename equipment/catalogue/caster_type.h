#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/config/table.h"
#include "engine/scene/equipment_model.h"
#include "equipment/catalogue/assumption.h"

namespace gurney::equipment {

/// A caster as one buys it; docs/formats/equipment_file.md has every key of its file.
struct CasterType {
  std::string name;
  std::string file;               ///< that describes it
  Caster properties;              ///< mount, heading, brake and lock are of the place, not set
  double brake_torque = 0;        ///< when on, may be infinite; 0: the caster has no brake [N m]
  double swivel_lock_torque = 0;  ///< the same for the swivel lock [N m]
  std::vector<Assumption> assumptions;  ///< besides those of brake and lock
  std::vector<Assumption> brake_assumptions;
  std::vector<Assumption> lock_assumptions;
};

/// Notes mistakes in the table's document; the result is for use only after its `finish`.
CasterType read_caster_type(config::Table table);

/// @param draw  of its uncertain numbers; none: as their values
/// @throws Error with every mistake of the file.
CasterType load_caster_type(const std::string& file, const std::optional<Draw>& draw = {});

}  // namespace gurney::equipment
