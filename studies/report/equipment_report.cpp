#include "studies/report/equipment_report.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "equipment/catalogue/caster_type.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/check_file.h"
#include "equipment/catalogue/floor_covering.h"
#include "equipment/catalogue/item_sheet.h"
#include "equipment/catalogue/load_item.h"
#include "equipment/catalogue/room_description.h"
#include "equipment/catalogue/tether_type.h"
#include "groundmotions/buildings/building.h"
#include "studies/report/formats.h"

namespace gurney::report {
namespace {

using findings::Section;
using findings::Table;
using findings::Value;

constexpr double kTransportTilt = 10, kOtherTilt = 5;  ///< of IEC 60601-1 [deg]

const findings::Format kMillimetres{".0f", "mm", 1 / kMillimetersPerMeter};
const findings::Format kDegrees{".1f", "deg", kRadiansPerDegree};
const findings::Format kWholeDegrees{".0f", "deg", kRadiansPerDegree};

double degrees(double radians) { return radians / kRadiansPerDegree; }

const char* met(double tilt, double least) { return tilt >= least ? "met" : "not met"; }

std::vector<findings::Numbers> rows_of(const Matrix3& matrix) {
  std::vector<findings::Numbers> rows;
  for (int i = 0; i < 3; ++i) rows.push_back({matrix(i, 0), matrix(i, 1), matrix(i, 2)});
  return rows;
}

Section body(const EquipmentFacts& facts) {
  const equipment::ItemSheet& sheet = facts.sheet;
  const findings::Format inertia{".4g", "kg m2"};
  Section of;
  of.fact("mass_kg", "mass", sheet.whole.mass, {".1f", "kg"});
  of.fact("size_m", "length, width, height", sheet.size, kMillimetres);
  of.fact("center_of_mass_m", "centre of mass", sheet.whole.center_of_mass, kMillimetres);
  of.json("inertia_kg_m2", rows_of(sheet.whole.inertia));
  of.text("inertia about x, y, z", Vector3(sheet.whole.inertia.diagonal()), inertia);
  of.fact("principal_inertia_kg_m2", "principal inertia", sheet.principal_inertia, inertia);
  of.fact("variants", "variants", facts.variants);
  return of;
}

Section stability(const EquipmentFacts& facts) {
  const equipment::ItemSheet& sheet = facts.sheet;
  const equipment::Stability& of = sheet.stability;
  const double tilt = degrees(of.tilt);
  const bool rolls = !facts.model.casters.empty();
  const findings::Format ratio{".2f"};
  const std::string worst = fmt::format("towards {:.0f} deg{}", degrees(of.direction),
                                        rolls ? ", swivels at their worst" : "");
  Section all{"", "stability"};
  all.fact("base_over_height_as_placed", "b / h", sheet.tipping_share, ratio,
           rolls ? "wheels as placed"
                 : fmt::format("slenderness h / b {:.1f}", 1 / sheet.tipping_share));
  all.fact("base_over_height", rolls ? "b / h at worst" : "", of.base / of.height, ratio,
           "swivels at their worst");
  all.fact("tilt_as_placed_rad", rolls ? "overturns, as placed, at" : "", of.tilt_as_placed,
           kDegrees);
  all.fact("tilt_rad", "overturns at a tilt of", of.tilt, kDegrees, worst);
  all.json("tilt_direction_rad", of.direction);
  all.text("IEC 60601-1",
           rolls ? fmt::format("10 deg in transport: {}; 5 deg otherwise: {}",
                               met(tilt, kTransportTilt), met(tilt, kOtherTilt))
                 : fmt::format("5 deg of what is not mobile: {}", met(tilt, kOtherTilt)));
  Table tilts{"tilts", "", {}};
  for (const equipment::TiltTowards& t : sheet.tilts)
    add_row(tilts, {{{"direction_rad", "tilt towards", kWholeDegrees}, t.direction},
                    {{"as_placed_rad", rolls ? "as placed" : "overturns", kDegrees}, t.as_placed},
                    {{"worst_rad", rolls ? "at worst" : "", kDegrees}, t.worst}});
  all.add(std::move(tilts));
  return all.say("0 deg is forward (x), 90 deg to the left (y)");
}

/// Feet of an item without casters.
Section feet(const EquipmentFacts& facts) {
  const ContactConstants& floor = facts.floor;
  const bool compliant = floor.kind == ContactConstants::Kind::kCompliant;
  const bool stands = facts.model.casters.empty();
  Section of{"floor_contact", stands ? "stands without casters" : ""};
  for (const Vector2& corner : facts.sheet.support_polygon)
    of.text(stands ? "corner of the support" : "", corner, kMillimetres);
  of.text(stands ? "material on the floor" : "",
          fmt::format("{}; friction {:.2g}, {}", facts.model.material, floor.friction,
                      compliant ? fmt::format("compliant, {:.3g} N/m and {:.3g} N s/m",
                                              floor.stiffness, floor.damping)
                                : fmt::format("restitution {:.2g}", floor.restitution)));
  of.json("material", facts.model.material).json("friction", floor.friction);
  of.json("restitution", compliant ? Value() : floor.restitution);
  of.json("stiffness_n_per_m", floor.stiffness);
  return of.json("damping_n_s_per_m", compliant ? floor.damping : Value());
}

Table wheels(const EquipmentFacts& facts) {
  Table table{"wheels", "wheels at rest", {}};
  for (std::size_t i = 0; i < facts.sheet.wheels.size(); ++i) {
    const equipment::WheelAtRest& wheel = facts.sheet.wheels[i];
    const Caster& caster = facts.model.casters[i];
    const bool braked = caster.brake_torque > 0, locked = caster.swivel_lock_torque > 0;
    add_row(table, {{{"caster", "caster"}, wheel.caster},
                    {{"contact_m", "x, y", kMillimetres}, wheel.contact},
                    {{"load_n", "load", {".1f", "N"}}, wheel.load},
                    {{"sink_m", "sink", {".2f", "mm", 1 / kMillimetersPerMeter}}, wheel.sink},
                    {{"", "state"},
                     std::string(caster.swivels ? "swivels" : "rigid") +
                         (braked ? ", braked" : "") + (locked ? ", swivel locked" : "")},
                    {"swivels", caster.swivels},
                    {"braked", braked},
                    {"swivel_locked", locked}});
  }
  return table;
}

/// Where its parts come to rest.
Table parts(const EquipmentFacts& facts) {
  Table table{"parts", "parts at rest", {}};
  for (const equipment::LoadedPart& part : facts.parts) {
    const Joint& joint = part.joint;
    const bool slides = joint.kind == Joint::Kind::kSlider;
    const double unit = slides ? 1 / kMillimetersPerMeter : kRadiansPerDegree;
    add_row(
        table,
        {{{"part", "part"}, part.model.name},
         {{"on", "on"},
          joint.base == 0 ? std::string("chassis") : facts.parts[joint.base - 1].model.name},
         {{"joint", "joint"}, equipment::name_of(joint.kind)},
         {{"mass_kg", "mass", {".1f", "kg"}}, chassis_with_payloads(part.model).mass},
         {{"", "q"}, fmt::format("{:.1f} {}", part.coordinate / unit + 0.0, slides ? "mm" : "deg")},
         {"coordinate", part.coordinate}});
  }
  return table;
}

Section motion(const EquipmentFacts& facts) {
  const equipment::ItemSheet& sheet = facts.sheet;
  const bool rolls = !facts.model.casters.empty();
  const auto rolling = [&](double value) { return rolls ? Value(value) : Value(); };
  const double resistance = sheet.rolling_resistance_coefficient;
  Section of{"", "under a slowly increasing acceleration of the floor"};
  of.json("rolling_resistance_n", rolling(sheet.rolling_resistance_force));
  of.fact("rolls_from_g", "brakes off, straight, rolls from", rolling(resistance), {".3f", "g"},
          fmt::format("{:.1f} N; a slope of {:.1f} %", sheet.rolling_resistance_force,
                      100 * resistance));
  of.fact("moves_with_brakes_as_they_are_from_g", "brakes as configured, moves from",
          rolling(sheet.holding_share), {".3f", "g"});
  of.fact("slides_from_g", rolls ? "wheels that cannot turn slide from" : "slides from",
          sheet.sliding_share, {".2f", "g"});
  of.fact("tips_from_g", "tips from", sheet.tipping_share, {".2f", "g"},
          "if it does not slide or roll before");
  if (!rolls)
    of.say(sheet.tipping_share < sheet.sliding_share ? "so it rocks before it slides"
                                                     : "so it slides before it rocks");
  return of;
}

void add_assumptions(Section& to, const std::vector<equipment::Assumption>& all, bool one_by_one) {
  to.say(fmt::format("{} of the parameters in use are assumptions{}", all.size(),
                     one_by_one ? ":" : " (--assumptions lists them)"));
  Table table{"assumptions", "", json_columns({"key", "value", "range", "reason"})};
  findings::Texts lines;
  for (const equipment::Assumption& a : all) {
    const bool number = a.choice.empty();
    table.add({a.key, number ? Value(a.value) : Value(a.choice),
               number ? Value(findings::Numbers{a.low, a.high}) : Value(), a.reason});
    lines.push_back((number ? fmt::format("{} = {:g} ({:g} to {:g})", a.key, a.value, a.low, a.high)
                            : a.key + " = " + a.choice) +
                    "\n" + a.reason);
  }
  to.add(std::move(table));
  if (one_by_one) to.list("", "assumptions", std::move(lines));
}

using findings::Table;

constexpr double kMillimetre = 1 / kMillimetersPerMeter;

Table items() {
  Table table{"items", "", {}};
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kItem)) {
    const equipment::LoadedItem item =
        equipment::load_item(equipment::find_data(equipment::DataKind::kItem, key, ""));
    const equipment::ItemSheet sheet =
        equipment::item_sheet(as_rigid(item), equipment::floor_contact(item));
    add_row(table,
            {{{"key", "item"}, key},
             {{"name", "name"}, item.model.name},
             {{"mass_kg", "mass", {".1f", "kg"}}, sheet.whole.mass},
             {{"height_m", "height", {".0f", "mm", kMillimetre}}, sheet.size.z()},
             {{"base_over_height", "b/h", {".2f"}}, sheet.stability.base / sheet.stability.height},
             {{"tilt_rad", "tilt", {".1f", "deg", kRadiansPerDegree}}, sheet.stability.tilt},
             {{"casters", "casters"}, item.model.casters.size()},
             {{"assumptions", "assumptions"}, item.assumptions.size()}});
  }
  return table;
}

Table casters() {
  Table table{"casters", "", {}};
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kCaster)) {
    const equipment::CasterType type =
        equipment::load_caster_type(equipment::find_data(equipment::DataKind::kCaster, key, ""))
            .stated();
    const Caster& c = type.properties;
    add_row(table, {{{"key", "caster"}, key},
                    {"name", type.name},
                    {{"wheel_radius_m", "wheel", {".0f", "mm", kMillimetre / 2}}, c.wheel_radius},
                    {{"height_m", "height", {".0f", "mm", kMillimetre}}, c.height},
                    {{"trail_m", "trail", {".1f", "mm", kMillimetre}}, c.trail},
                    {{"", "Cr / R", {".4f"}}, c.tread.rolling_friction_length / c.wheel_radius},
                    {"rolling_resistance_m", c.tread.rolling_friction_length},
                    {{"static_friction", "friction mu_s", {".2f"}}, c.tread.static_friction},
                    {{"brake_torque_n_m", "brake", {".3g", "N m"}}, type.brake_torque}});
  }
  return table;
}

Table floors() {
  Table table{"floors", "", {}};
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kFloor)) {
    const equipment::FloorCovering floor =
        equipment::load_floor_covering(equipment::find_data(equipment::DataKind::kFloor, key, ""))
            .stated();
    add_row(table, {{{"key", "floor covering"}, key},
                    {{"name", "name"}, floor.name},
                    {{"rolling_resistance_factor", "factor on Cr", {".2f"}},
                     floor.rolling_resistance_factor},
                    {{"friction_factor", "on friction", {".2f"}}, floor.friction_factor}});
  }
  return table;
}

Table rooms() {
  Table table{"rooms", "", {}};
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kRoom)) {
    equipment::RoomNames names;
    equipment::Uncertain<equipment::RoomDescription> model;
    const std::string name = equipment::load_room(
        equipment::find_data(equipment::DataKind::kRoom, key, ""), names, model);
    const equipment::RoomDescription& room = model.stated();
    add_row(table, {{{"key", "room"}, key},
                    {{"name", "name"}, name},
                    {{"shapes", "shapes"}, room.shapes.size()},
                    {{"zones", "zones"}, room.zones.size()},
                    {{"points", "points"}, room.points.size()},
                    {"assumptions", room.assumptions.size()}});
  }
  return table;
}

Table tethers() {
  Table table{"tethers", "", {}};
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kTether)) {
    const equipment::TetherType type =
        equipment::load_tether_type(equipment::find_data(equipment::DataKind::kTether, key, ""))
            .stated();
    add_row(table, {{{"key", "tether"}, key},
                    {{"name", "name"}, type.name},
                    {{"axial_stiffness_n", "EA", {"g", "N"}}, type.axial_stiffness},
                    {"damping_n_s_per_m", type.damping},
                    {{"strength_n", "strength", {"g", "N"}}, type.strength}});
  }
  return table;
}

/// First period [s]; NaN: rigid.
double period(double omega) { return omega > 0 ? 2 * std::numbers::pi / omega : std::nan(""); }
double first_period(const groundmotions::ModalAxis& axis) {
  return axis.empty() ? std::nan("") : period(axis.front().omega);
}

Table buildings() {
  Table table{"buildings",
              "",
              {{"key", "building"},
               {"name", "name"},
               {"storeys", "storeys"},
               {"period_h1_s", "T h1", {".3g", "s"}},
               {"period_h2_s", "T h2", {".3g", "s"}},
               {"period_vertical_s", "T vert.", {".3g", "s"}},
               {"period_isolated_s", "isolated", {".3g", "s"}}}};
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kBuilding)) {
    const groundmotions::Building building = groundmotions::building_from_file(
        equipment::find_data(equipment::DataKind::kBuilding, key, ""));
    table.add(
        {key, building.name, building.storeys,
         first_period(building[groundmotions::Direction::kH1]),
         first_period(building[groundmotions::Direction::kH2]),
         first_period(building[groundmotions::Direction::kVertical]),
         building.isolation ? period(std::sqrt(building.isolation->stiffness)) : std::nan("")});
  }
  return table;
}

}  // namespace

EquipmentFacts equipment_facts(const equipment::ItemDescription& item,
                               const equipment::LoadedItem& loaded) {
  const ContactConstants& floor = equipment::floor_contact(loaded);
  const EquipmentModel whole = as_rigid(loaded);
  EquipmentFacts facts{whole,           equipment::item_sheet(whole, floor),
                       floor,           item.description,
                       item.variants,   loaded.assumptions,
                       loaded.warnings, loaded.parts,
                       loaded.contents};
  const auto add = [&facts](const EquipmentModel& model) {
    for (std::string& finding : equipment::implausible(model))
      facts.warnings.push_back(std::move(finding));
  };
  add(whole);
  for (const equipment::LoadedContent& content : loaded.contents) add(content.model);
  return facts;
}

findings::Section equipment_findings(const EquipmentFacts& facts, bool with_assumptions) {
  Section all{"", facts.model.name};
  all.json("name", facts.model.name).json("description", facts.description);
  all.say(facts.description).add(body(facts)).add(stability(facts)).add(feet(facts));
  std::vector<findings::Numbers> polygon;
  for (const Vector2& corner : facts.sheet.support_polygon)
    polygon.push_back({corner.x(), corner.y()});
  all.json("support_polygon_m", polygon).add(wheels(facts));
  if (!facts.parts.empty()) all.add(parts(facts));
  all.add(motion(facts));
  add_assumptions(all, facts.assumptions, with_assumptions);
  return all.list("warnings", "warnings", facts.warnings);
}

findings::Section equipment_list() {
  findings::Section all;
  all.add(items()).say(
      "b/h and tilt: free swivels turned the worst way, locked ones as locked; without casters on "
      "its feet");
  all.add(casters()).add(floors()).add(rooms()).add(tethers()).add(buildings());
  return all.say("first periods of the building on a fixed base; -: rigid, not isolated");
}

}  // namespace gurney::report
