#include "studies/report/equipment_list.h"

#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "equipment/catalogue/caster_type.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/floor_covering.h"
#include "equipment/catalogue/item_sheet.h"
#include "equipment/catalogue/load_item.h"
#include "equipment/catalogue/room_description.h"
#include "equipment/catalogue/tether_type.h"
#include "groundmotions/buildings/building_reader.h"

namespace gurney::report {
namespace {

using findings::Table;

constexpr double kMillimetre = 1 / kMillimetersPerMeter;

Table items() {
  Table table{"items",
              "",
              {{"key", "item"},
               {"name", "name"},
               {"mass_kg", "mass", {".1f", "kg"}},
               {"height_m", "height", {".0f", "mm", kMillimetre}},
               {"base_over_height", "b/h", {".2f"}},
               {"tilt_rad", "tilt", {".1f", "deg", kRadiansPerDegree}},
               {"casters", "casters"},
               {"assumptions", "assumptions"}}};
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kItem)) {
    const equipment::LoadedItem item =
        equipment::load_item(equipment::find_data(equipment::DataKind::kItem, key, ""));
    const equipment::ItemSheet sheet =
        equipment::item_sheet(item.model, equipment::floor_contact(item));
    table.add({key, item.model.name, sheet.whole.mass, sheet.size.z(),
               sheet.stability.base / sheet.stability.height, sheet.stability.tilt,
               item.model.casters.size(), item.assumptions.size()});
  }
  return table;
}

Table casters() {
  Table table{"casters",
              "",
              {{"key", "caster"},
               {"name", ""},
               {"wheel_radius_m", "wheel", {".0f", "mm", kMillimetre / 2}},
               {"height_m", "height", {".0f", "mm", kMillimetre}},
               {"trail_m", "trail", {".1f", "mm", kMillimetre}},
               {"", "Cr / R", {".4f"}},
               {"rolling_resistance_m", ""},
               {"static_friction", "friction mu_s", {".2f"}},
               {"brake_torque_n_m", "brake", {".3g", "N m"}}}};
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kCaster)) {
    const equipment::CasterType type =
        equipment::load_caster_type(equipment::find_data(equipment::DataKind::kCaster, key, ""))
            .stated();
    const Caster& c = type.properties;
    table.add({key, type.name, c.wheel_radius, c.height, c.trail,
               c.tread.rolling_friction_length / c.wheel_radius, c.tread.rolling_friction_length,
               c.tread.static_friction, type.brake_torque});
  }
  return table;
}

Table floors() {
  Table table{"floors",
              "",
              {{"key", "floor covering"},
               {"name", "name"},
               {"rolling_resistance_factor", "factor on Cr", {".2f"}},
               {"friction_factor", "on friction", {".2f"}}}};
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kFloor)) {
    const equipment::FloorCovering floor =
        equipment::load_floor_covering(equipment::find_data(equipment::DataKind::kFloor, key, ""))
            .stated();
    table.add({key, floor.name, floor.rolling_resistance_factor, floor.friction_factor});
  }
  return table;
}

Table rooms() {
  Table table{"rooms",
              "",
              {{"key", "room"},
               {"name", "name"},
               {"shapes", "shapes"},
               {"zones", "zones"},
               {"points", "points"},
               {"assumptions", ""}}};
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kRoom)) {
    equipment::RoomNames names;
    equipment::Uncertain<equipment::RoomDescription> model;
    const std::string name = equipment::load_room(
        equipment::find_data(equipment::DataKind::kRoom, key, ""), names, model);
    const equipment::RoomDescription& room = model.stated();
    table.add({key, name, room.shapes.size(), room.zones.size(), room.points.size(),
               room.assumptions.size()});
  }
  return table;
}

Table tethers() {
  Table table{"tethers",
              "",
              {{"key", "tether"},
               {"name", "name"},
               {"axial_stiffness_n", "EA", {"g", "N"}},
               {"damping_n_s_per_m", ""},
               {"strength_n", "strength", {"g", "N"}}}};
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kTether)) {
    const equipment::TetherType type =
        equipment::load_tether_type(equipment::find_data(equipment::DataKind::kTether, key, ""))
            .stated();
    table.add({key, type.name, type.axial_stiffness, type.damping, type.strength});
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

findings::Section equipment_list() {
  findings::Section all;
  all.add(items()).say(
      "b/h and tilt: free swivels turned the worst way, locked ones as locked; without casters on "
      "its feet");
  all.add(casters()).add(floors()).add(rooms()).add(tethers()).add(buildings());
  return all.say("first periods of the building on a fixed base; -: rigid, not isolated");
}

}  // namespace gurney::report
