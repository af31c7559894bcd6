#pragma once

#include <string>
#include <vector>

#include "engine/config/table.h"
#include "engine/scene/contact_pair.h"
#include "equipment/catalogue/quantity.h"
#include "equipment/catalogue/uncertainty.h"

namespace gurney::equipment {

/// The keys of a contact's constants: friction, and restitution, with a numerical stiffness if
/// wanted, or stiffness and damping of a compliant contact. Errors are noted in the document.
/// @param rolls  whether they are of a round body: what it does not state is an assumption then
Uncertain<ContactConstants> read_contact_constants(Quantities in, bool rolls);

/// How the chassis of an item, or its feet, meet a hard smooth surface: the floor, a wall.
struct ItemContact {
  std::string material;  ///< see Scene::pairs; empty: the engine's constants
  ContactConstants constants;
  std::vector<Assumption> assumptions;
};

/// Reads a table [contact]: restitution, or damping for a compliant contact, not both. Errors are
/// noted in the table's document; the result is for use only after its `finish`.
/// @param rolls  whether what it is of has a round shape: else it has no rolling resistance
Uncertain<ItemContact> read_item_contact(config::Table table, bool rolls);

/// Contact constants of two materials with what they rest on (docs/formats/room_file.md).
struct MaterialContact {
  std::string one, other;
  ContactConstants constants;
  std::vector<Assumption> assumptions;
};

using ContactTable = Uncertain<std::vector<MaterialContact>>;

/// The tables [[contact]] of `parent`. Each is drawn as a part with the names of its materials.
/// Errors are noted in the document.
ContactTable read_contacts(config::Table& parent);

/// Contacts of equipment/contacts.toml.
/// @throws Error with every error of the file.
ContactTable usual_contacts();

/// The first of the two materials, in either order; nullptr if there is none.
const MaterialContact* find_contact(const std::vector<MaterialContact>& contacts,
                                    const std::string& one, const std::string& other);

/// Every material named, sorted.
std::vector<std::string> materials_in(const std::vector<MaterialContact>& contacts);

}  // namespace gurney::equipment
