#pragma once

#include <string>
#include <vector>

#include "engine/config/table.h"
#include "engine/scene/contact_pair.h"
#include "equipment/catalogue/uncertain.h"

namespace gurney::equipment {

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

/// Those of equipment/contacts.toml.
/// @throws Error with every error of the file.
ContactTable usual_contacts();

/// The first of the two materials, in either order; nullptr if there is none.
const MaterialContact* find_contact(const std::vector<MaterialContact>& contacts,
                                    const std::string& one, const std::string& other);

/// Every material named, sorted.
std::vector<std::string> materials_in(const std::vector<MaterialContact>& contacts);

}  // namespace gurney::equipment
