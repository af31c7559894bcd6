#include "equipment/catalogue/contact_constants.h"

namespace gurney::equipment {

using config::Range;

ContactConstants read_contact_constants(Quantities in) {
  ContactConstants constants;
  config::Table& table = in.table();
  const bool compliant = table.has("damping_n_s_per_m"), rebounds = table.has("restitution");
  if (compliant == rebounds)
    table.note("restitution", ": must be given, or damping_n_s_per_m, not both");
  constants.friction = in.number("friction", Range::not_negative());
  if (compliant) {
    constants.kind = ContactConstants::Kind::kCompliant;
    constants.stiffness = in.number("stiffness_n_per_m", Range::positive());
    constants.damping = in.number("damping_n_s_per_m", Range::not_negative());
  } else {
    constants.stiffness = in.number("stiffness_n_per_m", Range::positive(), constants.stiffness);
  }
  if (rebounds) constants.restitution = in.number("restitution", Range::within(0.01, 1));
  return constants;
}

}  // namespace gurney::equipment
