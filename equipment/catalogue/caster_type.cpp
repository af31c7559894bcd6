#include "equipment/catalogue/caster_type.h"

#include "engine/base/units.h"
#include "equipment/catalogue/quantity.h"

namespace gurney::equipment {
namespace {

using config::Range;

Range up_to_width(const Caster& caster) {
  return Range::within(0, caster.wheel_width * kMillimetersPerMeter);
}

Range above_radius(const Caster& caster) {
  return Range::more_than(caster.wheel_radius * kMillimetersPerMeter);
}

/// Into the caster's tread; its patch is no wider than the wheel, in a draw too.
void read_tread(Quantities in, Uncertain<CasterType>& type) {
  const StatedQuantity patch =
      in.length_mm("patch_width_mm", up_to_width(type.stated().properties));
  const StatedQuantity adhering = in.number("static_friction", Range::not_negative());
  const StatedQuantity sliding = in.number("kinetic_friction", Range::not_negative());
  in.keep_order("kinetic_friction", sliding, "static_friction", adhering);
  Uncertain<Tread> tread;
  tread.set(&Tread::normal_stiffness, in.number("normal_stiffness_n_per_m", Range::positive()));
  tread.set(&Tread::normal_damping, in.number("normal_damping_n_s_per_m", Range::not_negative()));
  tread.set(&Tread::tangential_stiffness,
            in.number("tangential_stiffness_n_per_m", Range::positive()));
  tread.set(&Tread::tangential_damping,
            in.number("tangential_damping_n_s_per_m", Range::not_negative()));
  tread.set(&Tread::relaxation_length, in.length_mm("relaxation_length_mm", Range::at_least(0.1)));
  tread.set(&Tread::patch_width, patch);
  tread.set(&Tread::rolling_friction_length,
            in.length_mm("rolling_resistance_mm", Range::not_negative()));
  tread.set(&Tread::static_friction, adhering);
  tread.set(&Tread::kinetic_friction, sliding);
  type.add([patch](CasterType& of_draw, Sampler& of) {
    of.check_drawn(patch, up_to_width(of_draw.properties));
  });
  type.set([](CasterType& of_draw) -> Tread& { return of_draw.properties.tread; },
           std::move(tread));
}

Uncertain<BearingFriction> read_bearing(Quantities in) {
  Uncertain<BearingFriction> bearing;
  bearing.set(&BearingFriction::coulomb, in.number("coulomb_n_m", Range::not_negative()));
  bearing.set(&BearingFriction::viscous, in.number("viscous_n_m_s_per_rad", Range::not_negative()));
  return bearing;
}

/// A uniform wheel of revolution: axial inertia ratio m R^2; a diameter gets half of it and
/// m w^2 / 12 for the width.
void set_inertia(CasterType& type) {
  Caster& caster = type.properties;
  const double m = caster.wheel_mass, r = caster.wheel_radius, w = caster.wheel_width;
  caster.wheel_axial_inertia = type.wheel_inertia_ratio * m * r * r;
  caster.wheel_transverse_inertia = caster.wheel_axial_inertia / 2 + m * w * w / 12;
  caster.fork_inertia = solid_box_inertia(caster.fork_mass, type.fork_box);
}

/// A setter of a property of the caster.
template <class Value>
auto property(Value Caster::*member) {
  return [member](CasterType& type) -> Value& { return type.properties.*member; };
}

}  // namespace

Uncertain<CasterType> read_caster_type(config::Table table) {
  CasterType fixed;
  fixed.file = table.document().path();
  fixed.name = table.text("name");
  table.text("description", "");
  Uncertain<CasterType> type(std::move(fixed));
  Quantities in(table);
  StatedQuantity diameter = in.length_mm("wheel_diameter_mm", Range::positive());
  diameter.divisor *= 2;
  type.set(property(&Caster::wheel_radius), diameter);
  type.set(property(&Caster::wheel_width), in.length_mm("wheel_width_mm", Range::positive()));
  const StatedQuantity height = in.length_mm("height_mm", above_radius(type.stated().properties));
  type.set(property(&Caster::height), height);
  type.add([height](CasterType& of_draw, Sampler& of) {
    of.check_drawn(height, above_radius(of_draw.properties));
  });
  type.set(property(&Caster::trail), in.length_mm("trail_mm", Range::not_negative()));
  type.set(property(&Caster::wheel_mass), in.number("wheel_mass_kg", Range::positive()));
  type.set(&CasterType::wheel_inertia_ratio,
           in.number("wheel_inertia_ratio", Range::within(0, 1).open_below()));
  type.set(property(&Caster::fork_mass), in.number("fork_mass_kg", Range::positive()));
  type.set(property(&Caster::fork_center_of_mass),
           in.vector_mm("fork_center_of_mass_mm", Range::any()));
  type.set(&CasterType::fork_box, in.vector_mm("fork_box_mm", Range::not_negative()));
  type.add([](CasterType& of_draw, Sampler&) { set_inertia(of_draw); });

  type.set(&CasterType::brake_torque,
           in.number("brake_torque_n_m", Range::positive().with_infinity(), 0.0),
           &CasterType::brake_assumptions);
  type.set(&CasterType::brake_sliding_ratio,
           in.number("brake_sliding_ratio", Range::within(0.1, 1), 1.0),
           &CasterType::brake_assumptions);
  if (table.has("brake_sliding_ratio") && !table.has("brake_torque_n_m"))
    table.note("brake_sliding_ratio", ": must go with brake_torque_n_m");
  type.set(&CasterType::swivel_lock_torque,
           in.number("swivel_lock_torque_n_m", Range::positive().with_infinity(), 0.0),
           &CasterType::lock_assumptions);

  const auto section = [&](const char* key, auto read) {
    if (auto part = table.table(key))
      read(Quantities(*part));
    else if (!table.has(key))
      table.note(key, ": missing; must be a table");
  };
  section("tread", [&](Quantities part) { read_tread(part, type); });
  section("axle", [&](Quantities part) { type.set(property(&Caster::axle), read_bearing(part)); });
  section("swivel",
          [&](Quantities part) { type.set(property(&Caster::swivel), read_bearing(part)); });
  return type;
}

Uncertain<CasterType> load_caster_type(const std::string& file) {
  config::Document document(file);
  document.root().choice("schema", {"gurney-caster/1"});
  Uncertain<CasterType> type = read_caster_type(document.root());
  document.finish();
  return type;
}

}  // namespace gurney::equipment
