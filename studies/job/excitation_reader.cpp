#include "studies/job/excitation_reader.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "engine/base/units.h"
#include "equipment/catalogue/quantity.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

/// Point and direction of a load.
template <typename Load>
void read_line(equipment::Quantities& in, equipment::Uncertain<Load>& load) {
  load.set(&Load::point, in.vector("point_m", Range::any()));
  load.set(&Load::direction, in.vector("direction", Range::any()));
  load.add(in.table().document(),
           [spot = in.table().spot("direction")](Load& of_draw, equipment::Sampler& of) {
             Vector3& direction = of_draw.direction;
             if (!(direction.norm() > 0)) {
               of.error(spot, " = [0, 0, 0]: must have a length");
               direction = Vector3::UnitX();
             }
             direction.normalize();
           });
}

void read_constant_force(equipment::Quantities& in, const Range& allowed,
                         equipment::Uncertain<PointForce>& load) {
  const equipment::StatedQuantity force = in.number("force_n", allowed);
  const equipment::StatedQuantity from = in.number("from_s", Range::not_negative(), 0.0);
  const equipment::StatedQuantity until = in.number("until_s", Range::more_than(from.value));
  load.add([force, from, until](PointForce& of_draw, equipment::Sampler& of) {
    const double newton = of(force), begin = of(from);
    of.check_drawn(until, Range::more_than(begin));
    of_draw.force = {newton, newton};
    of_draw.time = {begin, of(until)};
  });
  if (in.table().has("time_s"))
    in.table().note("time_s", ": must go with an array force_n; a constant force has until_s");
}

void read_force_table(Table& table, const Range& allowed, equipment::Uncertain<PointForce>& load) {
  const std::vector<double> force = table.numbers("force_n", allowed);
  const std::vector<double> time = table.numbers("time_s", Range::any(), force.size());
  if (force.size() < 2) table.note("force_n", ": must have 2 or more values");
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1])) {
      table.note("time_s", fmt::format("[{}] = {}: must be more than the time before it, {}", i,
                                       time[i], time[i - 1]));
      break;
    }
  for (const char* key : {"from_s", "until_s"})
    if (table.has(key)) table.note(key, ": must go with a constant force_n, not with a table");
  load.add([force, time](PointForce& of_draw, equipment::Sampler&) {
    of_draw.force = force;
    of_draw.time = time;
  });
}

equipment::Uncertain<PointForce> read_force(Table table, std::size_t index) {
  equipment::Quantities in(table);
  PointForce fixed;
  fixed.name = table.text("name", fmt::format("force {}", index + 1));
  equipment::Uncertain<PointForce> load(std::move(fixed));
  read_line(in, load);
  const bool limited = table.has("speed_limit_m_per_s");
  if (limited)
    load.set(&PointForce::speed_limit, in.number("speed_limit_m_per_s", Range::positive()));
  for (const char* key : {"time_s", "from_s", "until_s"}) table.has(key);
  const Range allowed = limited ? Range::not_negative() : Range::any();
  if (table.is_array("force_n"))
    read_force_table(table, allowed, load);
  else
    read_constant_force(in, allowed, load);
  return load;
}

equipment::Uncertain<DropWeight> read_drop_weight(equipment::Quantities in) {
  const DropWeight usual;
  equipment::Uncertain<DropWeight> load;
  read_line(in, load);
  load.set(&DropWeight::mass, in.number("mass_kg", Range::positive()));
  load.set(&DropWeight::drop_height, in.number("drop_height_m", Range::positive()));
  load.set(&DropWeight::pulley_inertia,
           in.number("pulley_inertia_kg_m2", Range::not_negative(), usual.pulley_inertia));
  load.set(&DropWeight::pulley_radius,
           in.number("pulley_radius_m", Range::positive(), usual.pulley_radius));
  load.set(
      &DropWeight::potentiometer_tension,
      in.number("potentiometer_tension_n", Range::not_negative(), usual.potentiometer_tension));
  load.set(&DropWeight::cable_stiffness,
           in.number("cable_stiffness_n_per_m", Range::positive(), usual.cable_stiffness));
  load.set(&DropWeight::cable_damping,
           in.number("cable_damping_n_s_per_m", Range::not_negative(), usual.cable_damping));
  return load;
}

equipment::Uncertain<StringPotentiometer> read_string_potentiometer(equipment::Quantities in) {
  equipment::Uncertain<StringPotentiometer> load;
  read_line(in, load);
  load.set(&StringPotentiometer::tension, in.number("tension_n", Range::not_negative()));
  return load;
}

equipment::Uncertain<Blocks> read_blocks(equipment::Quantities in) {
  const Blocks usual;
  equipment::Uncertain<Blocks> load;
  load.set(&Blocks::point, in.vector("point_m", Range::any()));
  load.set(&Blocks::stiffness, in.number("stiffness_n_per_m", Range::positive(), usual.stiffness));
  load.set(&Blocks::damping, in.number("damping_n_s_per_m", Range::not_negative(), usual.damping));
  load.set(&Blocks::release_time, in.number("release_time_s", Range::positive()));
  return load;
}

equipment::Uncertain<Guide> read_guide(Table& fixture, const std::string& key, bool translation) {
  Guide fixed;
  if (!fixture.is_table(key)) {
    static const std::vector<std::string> kKinds = {"free", "held"};
    fixed.kind = static_cast<Guide::Kind>(fixture.choice(key, kKinds, 0));
    return equipment::Uncertain<Guide>(fixed);
  }
  Table table = *fixture.table(key);
  const bool spring = translation && table.has("stiffness_n_per_m");
  if (translation && spring == table.has("velocity_m_per_s"))
    table.note("velocity_m_per_s", ": must be given, or stiffness_n_per_m, not both");
  fixed.kind = spring ? Guide::Kind::kSpring : Guide::Kind::kVelocity;
  equipment::Uncertain<Guide> guide(fixed);
  equipment::Quantities in(table);
  if (spring) {
    guide.set(&Guide::stiffness, in.number("stiffness_n_per_m", Range::not_negative()));
    guide.set(&Guide::damping, in.number("damping_n_s_per_m", Range::not_negative(), 0.0));
  } else if (translation) {
    guide.set(&Guide::velocity, in.number("velocity_m_per_s", Range::any(), 0.0));
  } else {
    guide.set(&Guide::velocity, in.angle_deg("velocity_deg_per_s", Range::any()));
  }
  return guide;
}

std::vector<Load>& loads_of_item(PlacedItem& item) { return item.loads; }

/// A member of the initial motion.
template <class Value>
auto initial(Value InitialMotion::*member) {
  return [member](PlacedItem& item) -> Value& { return item.initial.*member; };
}

}  // namespace

void read_loads(Table& table, equipment::Uncertain<PlacedItem>& item) {
  std::size_t forces = loads_of<PointForce>(item.stated().loads).size();
  for (Table& force : table.tables("force"))
    item.append(loads_of_item, read_force(force, forces++));
  for (Table& weight : table.tables("drop_weight"))
    item.append(loads_of_item, read_drop_weight(equipment::Quantities(weight)));
  for (Table& string : table.tables("string_potentiometer"))
    item.append(loads_of_item, read_string_potentiometer(equipment::Quantities(string)));
  for (Table& blocks : table.tables("blocks"))
    item.append(loads_of_item, read_blocks(equipment::Quantities(blocks)));
}

void read_fixture(Table& fixture, equipment::Uncertain<PlacedItem>& item) {
  static constexpr std::array kDegreesOfFreedom = {"x", "y", "z", "roll", "pitch", "yaw"};
  for (std::size_t i = 0; i < kDegreesOfFreedom.size(); ++i)
    item.set([i](PlacedItem& of_draw) -> Guide& { return of_draw.fixture.guides[i]; },
             read_guide(fixture, kDegreesOfFreedom[i], i < 3));
}

void read_initial(Table& table, equipment::Uncertain<PlacedItem>& item) {
  equipment::Quantities in(table);
  item.set(initial(&InitialMotion::velocity),
           in.vector("velocity_m_per_s", Range::any(), Vector3::Zero()));
  item.set(initial(&InitialMotion::yaw_rate),
           in.angle_deg("yaw_rate_deg_per_s", Range::any(), 0.0));
  item.add([roll = table.boolean("wheels_roll", InitialMotion().wheels_roll)](
               PlacedItem& of_draw, equipment::Sampler&) { of_draw.initial.wheels_roll = roll; });
}

}  // namespace gurney::study
