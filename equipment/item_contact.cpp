#include "equipment/item_contact.h"

#include "equipment/quantity.h"

namespace gurney {

using config::Range;

ItemContact read_item_contact(config::Table table) {
  ItemContact contact;
  Quantities in(table, contact.assumptions);
  contact.material = table.text("material");
  if (contact.material.empty()) table.note("material", " = \"\": must be the name of a material");
  ContactConstants& constants = contact.constants;
  constants.friction = in.number("friction", Range::not_negative());
  constants.stiffness = in.number("stiffness_n_per_m", Range::positive());
  const bool compliant = table.has("damping_n_s_per_m");
  if (compliant == table.has("restitution"))
    table.note("restitution", ": must be given, or damping_n_s_per_m, not both");
  if (compliant) {
    constants.kind = ContactConstants::Kind::kCompliant;
    constants.damping = in.number("damping_n_s_per_m", Range::not_negative());
  }
  if (table.has("restitution"))
    constants.restitution = in.number("restitution", Range::within(0.01, 1));
  return contact;
}

}  // namespace gurney
