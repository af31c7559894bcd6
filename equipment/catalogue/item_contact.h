#pragma once

#include <string>
#include <vector>

#include "engine/config/table.h"
#include "engine/scene/contact_pair.h"
#include "equipment/catalogue/uncertain.h"

namespace gurney::equipment {

/// How the chassis of an item, or its feet, meet a hard smooth surface: the floor, a wall.
struct ItemContact {
  std::string material;  ///< see Scene::pairs; empty: the engine's constants
  ContactConstants constants;
  std::vector<Assumption> assumptions;
};

/// Reads a table [contact]: restitution, or damping for a compliant contact, not both. Errors are
/// noted in the table's document; the result is for use only after its `finish`.
Uncertain<ItemContact> read_item_contact(config::Table table);

}  // namespace gurney::equipment
