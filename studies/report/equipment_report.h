#pragma once

#include <string>
#include <vector>

#include "engine/scene/contact_pair.h"
#include "equipment/catalogue/assumption.h"
#include "equipment/catalogue/item_sheet.h"
#include "equipment/catalogue/load_item.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// An item ready for a report.
struct EquipmentFacts {
  EquipmentModel model;  ///< as_rigid: the shapes of its parts come after those of the chassis
  equipment::ItemSheet sheet;
  ContactConstants floor;  ///< of the chassis, or the feet, with the floor
  std::string description;
  std::vector<std::string> variants;
  std::vector<equipment::Assumption> assumptions;
  std::vector<std::string> warnings;
  std::vector<equipment::LoadedPart> parts = {};
  std::vector<equipment::LoadedContent> contents = {};
};

/// Facts of an item as it is described, with implausible numbers among the warnings.
EquipmentFacts equipment_facts(const equipment::ItemDescription& item,
                               const equipment::LoadedItem& loaded);

/// Mass, inertia, support, tilt, wheel loads, resistance, every number that has no source.
/// @param with_assumptions  people read them one by one
findings::Section equipment_findings(const EquipmentFacts& facts, bool with_assumptions);

/// The catalogue as tables.
/// @throws Error with the errors of a catalogue file.
findings::Section equipment_list();

}  // namespace gurney::report
