#pragma once

#include <string>
#include <vector>

#include "engine/scene/contact_pair.h"
#include "equipment/catalogue/assumption.h"
#include "equipment/catalogue/item_sheet.h"

namespace gurney::report {

/// An item ready for a report.
struct EquipmentFacts {
  EquipmentModel model;
  equipment::ItemSheet sheet;
  ContactConstants floor;  ///< of the chassis, or the feet, with the floor
  std::string description;
  std::vector<std::string> variants;
  std::vector<equipment::Assumption> assumptions;
  std::vector<std::string> warnings;
};

/// For people: mass, inertia, support, tilt, wheel loads, resistance; with `with_assumptions` every
/// number that has no source.
std::string equipment_report(const EquipmentFacts& facts, bool with_assumptions);

/// The same as a JSON object, in SI units.
std::string equipment_json(const EquipmentFacts& facts);

}  // namespace gurney::report
