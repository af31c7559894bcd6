#pragma once

#include <string>
#include <vector>

#include "engine/config/table.h"
#include "engine/scene/equipment_model.h"
#include "equipment/catalogue/assumption.h"
#include "equipment/catalogue/uncertainty.h"

namespace gurney::equipment {

/// A caster as one buys it; docs/formats/equipment_file.md has every key of its file.
struct CasterType {
  std::string name;
  std::string file;                    ///< that describes it
  Caster properties;                   ///< mount, heading, brake and lock are of the place, not set
  double wheel_inertia_ratio = 0;      ///< axial moment of the wheel over m R^2
  Vector3 fork_box = Vector3::Zero();  ///< of the fork's moments of inertia [m]
  double brake_torque = 0;         ///< when on, may be infinite; 0: the caster has no brake [N m]
  double brake_sliding_ratio = 1;  ///< torque of a brake that slips over that which it held
  double swivel_lock_torque = 0;   ///< the same for the swivel lock [N m]
  std::vector<Assumption> assumptions;  ///< besides those of brake and lock
  std::vector<Assumption> brake_assumptions;
  std::vector<Assumption> lock_assumptions;
};

/// Notes errors in the table's document; the result is for use only after its `finish`.
Uncertain<CasterType> read_caster_type(config::Table table);

/// @throws Error with every error of the file.
Uncertain<CasterType> load_caster_type(const std::string& file);

}  // namespace gurney::equipment
