#include "equipment/catalogue/contact_constants.h"

namespace gurney::equipment {

using config::Range;

Uncertain<ContactConstants> read_contact_constants(Quantities in) {
  ContactConstants fixed;
  config::Table& table = in.table();
  const bool compliant = table.has("damping_n_s_per_m"), rebounds = table.has("restitution");
  if (compliant == rebounds)
    table.note("restitution", ": must be given, or damping_n_s_per_m, not both");
  if (compliant) fixed.kind = ContactConstants::Kind::kCompliant;
  Uncertain<ContactConstants> constants(fixed);
  constants.set(&ContactConstants::friction, in.number("friction", Range::not_negative()));
  const std::optional<double> stiffness = compliant ? std::nullopt : std::optional(fixed.stiffness);
  constants.set(&ContactConstants::stiffness,
                in.number("stiffness_n_per_m", Range::positive(), stiffness));
  if (compliant)
    constants.set(&ContactConstants::damping,
                  in.number("damping_n_s_per_m", Range::not_negative()));
  if (rebounds)
    constants.set(&ContactConstants::restitution, in.number("restitution", Range::within(0.01, 1)));
  return constants;
}

}  // namespace gurney::equipment
