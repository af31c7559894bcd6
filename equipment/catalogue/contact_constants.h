#pragma once

#include "engine/scene/contact_pair.h"
#include "equipment/catalogue/quantity.h"
#include "equipment/catalogue/uncertain.h"

namespace gurney::equipment {

/// The keys of a contact's constants: friction, and restitution, with a numerical stiffness if
/// wanted, or stiffness and damping of a compliant contact. Errors are noted in the document.
Uncertain<ContactConstants> read_contact_constants(Quantities in);

}  // namespace gurney::equipment
