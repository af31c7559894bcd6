#include "equipment/catalogue/caster_type.h"

#include "engine/base/units.h"
#include "equipment/catalogue/quantity.h"

namespace gurney::equipment {
namespace {

using config::Range;

Tread read_tread(Quantities in, double wheel_width) {
  Tread tread;
  tread.normal_stiffness = in.number("normal_stiffness_n_per_m", Range::positive());
  tread.normal_damping = in.number("normal_damping_n_s_per_m", Range::not_negative());
  tread.tangential_stiffness = in.number("tangential_stiffness_n_per_m", Range::positive());
  tread.tangential_damping = in.number("tangential_damping_n_s_per_m", Range::not_negative());
  tread.relaxation_length = in.length_mm("relaxation_length_mm", Range::at_least(0.1));
  tread.patch_width =
      in.length_mm("patch_width_mm", Range::within(0, wheel_width * kMillimetersPerMeter));
  tread.rolling_resistance = in.length_mm("rolling_resistance_mm", Range::not_negative());
  tread.static_friction = in.number("static_friction", Range::not_negative());
  tread.kinetic_friction = in.number("kinetic_friction", Range::not_negative());
  in.keep_order("kinetic_friction", tread.kinetic_friction, "static_friction",
                tread.static_friction);
  return tread;
}

BearingFriction read_bearing(Quantities in) {
  return {in.number("coulomb_n_m", Range::not_negative()),
          in.number("viscous_n_m_s_per_rad", Range::not_negative())};
}

/// A uniform wheel of revolution: axial inertia ratio m R^2; a diameter gets half of it and
/// m w^2 / 12 for the width.
void set_wheel_inertia(Caster& caster, double ratio) {
  const double m = caster.wheel_mass, r = caster.wheel_radius, w = caster.wheel_width;
  caster.wheel_axial_inertia = ratio * m * r * r;
  caster.wheel_transverse_inertia = caster.wheel_axial_inertia / 2 + m * w * w / 12;
}

}  // namespace

CasterType read_caster_type(config::Table table) {
  CasterType type;
  type.file = table.document().path();
  type.name = table.text("name");
  table.text("description", "");
  Quantities in(table, type.assumptions);
  Caster& caster = type.properties;
  caster.wheel_radius = in.length_mm("wheel_diameter_mm", Range::positive()) / 2;
  caster.wheel_width = in.length_mm("wheel_width_mm", Range::positive());
  caster.height =
      in.length_mm("height_mm", Range::more_than(caster.wheel_radius * kMillimetersPerMeter));
  caster.trail = in.length_mm("trail_mm", Range::not_negative());
  caster.wheel_mass = in.number("wheel_mass_kg", Range::positive());
  set_wheel_inertia(caster, in.number("wheel_inertia_ratio", Range::within(0, 1).open_below()));
  caster.fork_mass = in.number("fork_mass_kg", Range::positive());
  caster.fork_center_of_mass = in.vector_mm("fork_center_of_mass_mm", Range::any());
  caster.fork_inertia =
      solid_box_inertia(caster.fork_mass, in.vector_mm("fork_box_mm", Range::not_negative()));

  type.brake_torque = Quantities(table, type.brake_assumptions)
                          .number("brake_torque_n_m", Range::positive().with_infinity(), 0.0);
  type.swivel_lock_torque =
      Quantities(table, type.lock_assumptions)
          .number("swivel_lock_torque_n_m", Range::positive().with_infinity(), 0.0);

  const auto section = [&](const char* key, auto read) {
    if (auto part = table.table(key))
      read(Quantities(*part, type.assumptions));
    else if (!table.has(key))
      table.note(key, ": missing; must be a table");
  };
  section("tread", [&](Quantities part) { caster.tread = read_tread(part, caster.wheel_width); });
  section("axle", [&](Quantities part) { caster.axle = read_bearing(part); });
  section("swivel", [&](Quantities part) { caster.swivel = read_bearing(part); });
  return type;
}

CasterType load_caster_type(const std::string& file, const std::optional<Draw>& draw) {
  config::Document document(file);
  document.set_draw(draw);
  document.root().choice("schema", {"gurney-caster/1"});
  CasterType type = read_caster_type(document.root());
  document.finish();
  return type;
}

}  // namespace gurney::equipment
