#include "studies/study/job/excitation_reader.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "engine/base/units.h"
#include "equipment/catalogue/quantity.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

Vector3 read_direction(equipment::Quantities& in) {
  const Vector3 direction = in.vector("direction", Range::any());
  if (direction.norm() > 0) return direction.normalized();
  in.table().note("direction", " = [0, 0, 0]: must have a length");
  return Vector3::UnitX();
}

Vector3 read_point(equipment::Quantities& in) { return in.vector("point_m", Range::any()); }

PointForce read_force(Table table, std::size_t index,
                      std::vector<equipment::Assumption>& assumptions) {
  equipment::Quantities in(table, assumptions);
  PointForce load;
  load.name = table.text("name", fmt::format("force {}", index + 1));
  load.point = read_point(in);
  load.direction = read_direction(in);
  if (table.has("speed_limit_m_per_s"))
    load.speed_limit = in.number("speed_limit_m_per_s", Range::positive());
  for (const char* key : {"time_s", "from_s", "until_s"}) table.has(key);
  const Range allowed = std::isinf(load.speed_limit) ? Range::any() : Range::not_negative();
  if (!table.is_array("force_n")) {
    const double force = in.number("force_n", allowed);
    const double from = in.number("from_s", Range::not_negative(), 0.0);
    load.time = {from, in.number("until_s", Range::more_than(from))};
    load.force = {force, force};
    if (table.has("time_s"))
      table.note("time_s", ": must go with an array force_n; a constant force has until_s");
    return load;
  }
  load.force = table.numbers("force_n", allowed);
  load.time = table.numbers("time_s", Range::any(), load.force.size());
  if (load.force.size() < 2) table.note("force_n", ": must have 2 or more values");
  for (std::size_t i = 1; i < load.time.size(); ++i)
    if (!(load.time[i] > load.time[i - 1])) {
      table.note("time_s", fmt::format("[{}] = {}: must be more than the time before it, {}", i,
                                       load.time[i], load.time[i - 1]));
      break;
    }
  for (const char* key : {"from_s", "until_s"})
    if (table.has(key)) table.note(key, ": must go with a constant force_n, not with a table");
  return load;
}

DropWeight read_drop_weight(equipment::Quantities in) {
  DropWeight load;
  load.point = read_point(in);
  load.direction = read_direction(in);
  load.mass = in.number("mass_kg", Range::positive());
  load.drop_height = in.number("drop_height_m", Range::positive());
  load.pulley_inertia =
      in.number("pulley_inertia_kg_m2", Range::not_negative(), load.pulley_inertia);
  load.pulley_radius = in.number("pulley_radius_m", Range::positive(), load.pulley_radius);
  load.potentiometer_tension =
      in.number("potentiometer_tension_n", Range::not_negative(), load.potentiometer_tension);
  load.cable_stiffness =
      in.number("cable_stiffness_n_per_m", Range::positive(), load.cable_stiffness);
  load.cable_damping =
      in.number("cable_damping_n_s_per_m", Range::not_negative(), load.cable_damping);
  return load;
}

StringPotentiometer read_string_potentiometer(equipment::Quantities in) {
  StringPotentiometer load;
  load.point = read_point(in);
  load.direction = read_direction(in);
  load.tension = in.number("tension_n", Range::not_negative());
  return load;
}

Blocks read_blocks(equipment::Quantities in) {
  Blocks load;
  load.point = read_point(in);
  load.stiffness = in.number("stiffness_n_per_m", Range::positive(), load.stiffness);
  load.damping = in.number("damping_n_s_per_m", Range::not_negative(), load.damping);
  load.release_time = in.number("release_time_s", Range::positive());
  return load;
}

Guide read_guide(Table& fixture, const std::string& key, bool translation,
                 std::vector<equipment::Assumption>& assumptions) {
  Guide guide;
  if (!fixture.is_table(key)) {
    static const std::vector<std::string> kKinds = {"free", "held"};
    guide.kind = static_cast<Guide::Kind>(fixture.choice(key, kKinds, 0));
    return guide;
  }
  Table table = *fixture.table(key);
  equipment::Quantities in(table, assumptions);
  if (!translation) {
    guide.kind = Guide::Kind::kVelocity;
    guide.velocity = in.number("velocity_deg_per_s", Range::any()) * kRadiansPerDegree;
    return guide;
  }
  const bool spring = table.has("stiffness_n_per_m");
  if (spring == table.has("velocity_m_per_s"))
    table.note("velocity_m_per_s", ": must be given, or stiffness_n_per_m, not both");
  guide.kind = spring ? Guide::Kind::kSpring : Guide::Kind::kVelocity;
  if (spring) {
    guide.stiffness = in.number("stiffness_n_per_m", Range::not_negative());
    guide.damping = in.number("damping_n_s_per_m", Range::not_negative(), 0.0);
  } else {
    guide.velocity = in.number("velocity_m_per_s", Range::any(), 0.0);
  }
  return guide;
}

}  // namespace

void read_loads(Table& table, std::vector<equipment::Assumption>& assumptions,
                std::vector<Load>& loads) {
  std::size_t forces = loads_of<PointForce>(loads).size();
  for (Table& force : table.tables("force"))
    loads.push_back(read_force(force, forces++, assumptions));
  for (Table& weight : table.tables("drop_weight"))
    loads.push_back(read_drop_weight(equipment::Quantities(weight, assumptions)));
  for (Table& string : table.tables("string_potentiometer"))
    loads.push_back(read_string_potentiometer(equipment::Quantities(string, assumptions)));
  for (Table& blocks : table.tables("blocks"))
    loads.push_back(read_blocks(equipment::Quantities(blocks, assumptions)));
}

Fixture read_fixture(Table& fixture, std::vector<equipment::Assumption>& assumptions) {
  static constexpr std::array kDegreesOfFreedom = {"x", "y", "z", "roll", "pitch", "yaw"};
  Fixture result;
  for (std::size_t i = 0; i < kDegreesOfFreedom.size(); ++i)
    result.guides[i] = read_guide(fixture, kDegreesOfFreedom[i], i < 3, assumptions);
  return result;
}

void read_initial(Table& initial, std::vector<equipment::Assumption>& assumptions,
                  InitialMotion& motion) {
  equipment::Quantities in(initial, assumptions);
  motion.velocity = in.vector("velocity_m_per_s", Range::any(), Vector3::Zero());
  motion.yaw_rate = in.number("yaw_rate_deg_per_s", Range::any(), 0.0) * kRadiansPerDegree;
  motion.wheels_roll = initial.boolean("wheels_roll", motion.wheels_roll);
}

}  // namespace gurney::study
