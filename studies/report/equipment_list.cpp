#include "studies/report/equipment_list.h"

#include <cmath>
#include <nlohmann/json.hpp>
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
#include "studies/report/report_table.h"

namespace gurney::report {
namespace {

constexpr double kDegree = 1 / kRadiansPerDegree;

ReportTable items() {
  ReportTable table({{"item", "<24", "", "key"},
                     {"name", "<52", "", "name"},
                     {"kg", ">7", ".1f", "mass_kg"},
                     {"mm high", ">7", ".0f", "height_m", kMillimetersPerMeter},
                     {"b/h", ">6", ".2f", "base_over_height"},
                     {"tilt [deg]", ">10", ".1f", "tilt_rad", kDegree},
                     {"casters", ">8", "", "casters"},
                     {"assumptions", ">12", "", "assumptions"}});
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

ReportTable casters() {
  ReportTable table({{"caster", "<24", "", "key"},
                     {"", "", "", "name"},
                     {"wheel [mm]", ">10", ".0f", "wheel_radius_m", 2 * kMillimetersPerMeter},
                     {"high [mm]", ">9", ".0f", "height_m", kMillimetersPerMeter},
                     {"trail", ">8", ".1f", "trail_m", kMillimetersPerMeter},
                     {"Cr / R", ">7", ".4f", ""},
                     {"", "", "", "rolling_resistance_m"},
                     {"friction mu_s", ">13", ".2f", "static_friction"},
                     {"brake [N m]", ">11", ".3g", "brake_torque_n_m"}});
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

ReportTable floors() {
  ReportTable table({{"floor covering", "<24", "", "key"},
                     {"name", "<40", "", "name"},
                     {"factor on Cr", ">12", ".2f", "rolling_resistance_factor"},
                     {"on friction", ">12", ".2f", "friction_factor"}});
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kFloor)) {
    const equipment::FloorCovering floor =
        equipment::load_floor_covering(equipment::find_data(equipment::DataKind::kFloor, key, ""))
            .stated();
    table.add({key, floor.name, floor.rolling_resistance_factor, floor.friction_factor});
  }
  return table;
}

ReportTable rooms() {
  ReportTable table({{"room", "<24", "", "key"},
                     {"name", "<40", "", "name"},
                     {"shapes", ">12", "", "shapes"},
                     {"zones", ">12", "", "zones"},
                     {"points", ">12", "", "points"},
                     {"", "", "", "assumptions"}});
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

ReportTable tethers() {
  ReportTable table({{"tether", "<24", "", "key"},
                     {"name", "<40", "", "name"},
                     {"EA [N]", ">12", "g", "axial_stiffness_n"},
                     {"", "", "", "damping_n_s_per_m"},
                     {"strength [N]", ">12", "g", "strength_n"}});
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

ReportTable buildings() {
  ReportTable table({{"building", "<28", "", "key"},
                     {"name", "<44", "", "name"},
                     {"storeys", ">8", "", "storeys"},
                     {"T h1 [s]", ">9", ".3g", "period_h1_s"},
                     {"T h2 [s]", ">9", ".3g", "period_h2_s"},
                     {"T vert. [s]", ">11", ".3g", "period_vertical_s"},
                     {"isolated [s]", ">12", ".3g", "period_isolated_s"}});
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kBuilding)) {
    const groundmotions::Building building = groundmotions::building_from_file(
        equipment::find_data(equipment::DataKind::kBuilding, key, ""));
    table.add(
        {key, building.name, static_cast<std::size_t>(building.storeys),
         first_period(building[groundmotions::Direction::kH1]),
         first_period(building[groundmotions::Direction::kH2]),
         first_period(building[groundmotions::Direction::kVertical]),
         building.isolation ? period(std::sqrt(building.isolation->stiffness)) : std::nan("")});
  }
  return table;
}

}  // namespace

std::string equipment_list() {
  return items().text() +
         "b/h and tilt: free swivels turned the worst way, locked ones as locked; without casters "
         "on its feet\n\n" +
         casters().text() + "\n" + floors().text() + "\n" + rooms().text() + "\n" +
         tethers().text() + "\n" + buildings().text() +
         "first periods of the building on a fixed base; -: rigid, not isolated\n";
}

std::string equipment_list_json() {
  const nlohmann::ordered_json lists = {
      {"items", items().json()}, {"casters", casters().json()}, {"floors", floors().json()},
      {"rooms", rooms().json()}, {"tethers", tethers().json()}, {"buildings", buildings().json()}};
  return lists.dump(2) + "\n";
}

}  // namespace gurney::report
