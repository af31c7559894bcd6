#include "studies/report/equipment_list.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/base/units.h"
#include "equipment/catalogue/caster_type.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/floor_covering.h"
#include "equipment/catalogue/item_sheet.h"
#include "equipment/catalogue/load_item.h"
#include "equipment/catalogue/room_description.h"
#include "equipment/catalogue/tether_type.h"

namespace gurney::report {
namespace {

struct ListedItem {
  std::string key;
  equipment::LoadedItem item;
  equipment::ItemSheet sheet;
};

std::vector<ListedItem> items() {
  std::vector<ListedItem> result;
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kItem)) {
    equipment::LoadedItem item =
        equipment::load_item(equipment::find_data(equipment::DataKind::kItem, key, ""));
    equipment::ItemSheet sheet = equipment::item_sheet(item.model, equipment::floor_contact(item));
    result.push_back({key, std::move(item), std::move(sheet)});
  }
  return result;
}

equipment::CasterType caster(const std::string& key) {
  return equipment::load_caster_type(find_data(equipment::DataKind::kCaster, key, "")).stated();
}

equipment::FloorCovering floor(const std::string& key) {
  return equipment::load_floor_covering(find_data(equipment::DataKind::kFloor, key, "")).stated();
}

struct ListedRoom {
  std::string key, name;
  equipment::RoomDescription room;
};

std::vector<ListedRoom> rooms() {
  std::vector<ListedRoom> result;
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kRoom)) {
    equipment::RoomNames names;
    equipment::Uncertain<equipment::RoomDescription> room;
    const std::string name = load_room(find_data(equipment::DataKind::kRoom, key, ""), names, room);
    result.push_back({key, name, room.stated()});
  }
  return result;
}

equipment::TetherType tether(const std::string& key) {
  return equipment::load_tether_type(find_data(equipment::DataKind::kTether, key, "")).stated();
}

}  // namespace

std::string equipment_list() {
  std::string text =
      fmt::format("{:<24} {:<52} {:>7} {:>7} {:>6} {:>9} {:>8} {:>12}\n", "item", "name", "kg",
                  "mm high", "b/h", "tilt [deg]", "casters", "assumptions");
  for (const auto& [key, item, sheet] : items())
    text += fmt::format("{:<24} {:<52} {:>7.1f} {:>7.0f} {:>6.2f} {:>9.1f} {:>9} {:>12}\n", key,
                        item.model.name, sheet.whole.mass, sheet.size.z() * kMillimetersPerMeter,
                        sheet.stability.base / sheet.stability.height,
                        sheet.stability.tilt / kRadiansPerDegree, item.model.casters.size(),
                        item.assumptions.size());
  text +=
      "b/h and tilt: free swivels turned the worst way, locked ones as locked; without casters on "
      "its "
      "feet\n";
  text += fmt::format("\n{:<24} {:>9} {:>9} {:>8} {:>7} {:>13} {:>10}\n", "caster", "wheel [mm]",
                      "high [mm]", "trail", "Cr / R", "friction mu_s", "brake [N m]");
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kCaster)) {
    const equipment::CasterType type = caster(key);
    const Caster& c = type.properties;
    text += fmt::format("{:<24} {:>9.0f} {:>9.0f} {:>8.1f} {:>8.4f} {:>13.2f} {:>10.3g}\n", key,
                        2 * c.wheel_radius * kMillimetersPerMeter, c.height * kMillimetersPerMeter,
                        c.trail * kMillimetersPerMeter, c.tread.rolling_resistance / c.wheel_radius,
                        c.tread.static_friction, type.brake_torque);
  }
  text += fmt::format("\n{:<24} {:<40} {:>12} {:>12}\n", "floor covering", "name", "factor on Cr",
                      "on friction");
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kFloor)) {
    const equipment::FloorCovering covering = floor(key);
    text += fmt::format("{:<24} {:<40} {:>12.2f} {:>12.2f}\n", key, covering.name,
                        covering.rolling_resistance_factor, covering.friction_factor);
  }
  text += fmt::format("\n{:<24} {:<40} {:>12} {:>12} {:>12}\n", "room", "name", "shapes", "zones",
                      "points");
  for (const auto& [key, name, room] : rooms())
    text += fmt::format("{:<24} {:<40} {:>12} {:>12} {:>12}\n", key, name, room.shapes.size(),
                        room.zones.size(), room.points.size());
  text +=
      fmt::format("\n{:<24} {:<40} {:>12} {:>12}\n", "tether", "name", "EA [N]", "strength [N]");
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kTether)) {
    const equipment::TetherType type = tether(key);
    text += fmt::format("{:<24} {:<40} {:>12g} {:>12g}\n", key, type.name, type.axial_stiffness,
                        type.strength);
  }
  return text;
}

std::string equipment_list_json() {
  using Json = nlohmann::ordered_json;
  Json listed = Json::array(), casters = Json::array(), floors = Json::array();
  Json listed_rooms = Json::array(), tethers = Json::array();
  for (const auto& [key, item, sheet] : items())
    listed.push_back({{"key", key},
                      {"name", item.model.name},
                      {"mass_kg", sheet.whole.mass},
                      {"height_m", sheet.size.z()},
                      {"base_over_height", sheet.stability.base / sheet.stability.height},
                      {"tilt_rad", sheet.stability.tilt},
                      {"casters", item.model.casters.size()},
                      {"assumptions", item.assumptions.size()}});
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kCaster)) {
    const equipment::CasterType type = caster(key);
    const Caster& c = type.properties;
    casters.push_back({{"key", key},
                       {"name", type.name},
                       {"wheel_radius_m", c.wheel_radius},
                       {"height_m", c.height},
                       {"trail_m", c.trail},
                       {"rolling_resistance_m", c.tread.rolling_resistance},
                       {"static_friction", c.tread.static_friction},
                       {"brake_torque_n_m", type.brake_torque}});
  }
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kFloor)) {
    const equipment::FloorCovering covering = floor(key);
    floors.push_back({{"key", key},
                      {"name", covering.name},
                      {"rolling_resistance_factor", covering.rolling_resistance_factor},
                      {"friction_factor", covering.friction_factor}});
  }
  for (const auto& [key, name, room] : rooms())
    listed_rooms.push_back({{"key", key},
                            {"name", name},
                            {"shapes", room.shapes.size()},
                            {"zones", room.zones.size()},
                            {"points", room.points.size()},
                            {"assumptions", room.assumptions.size()}});
  for (const std::string& key : equipment::catalogue_names(equipment::DataKind::kTether)) {
    const equipment::TetherType type = tether(key);
    tethers.push_back({{"key", key},
                       {"name", type.name},
                       {"axial_stiffness_n", type.axial_stiffness},
                       {"damping_n_s_per_m", type.damping},
                       {"strength_n", type.strength}});
  }
  return Json{{"items", listed},
              {"casters", casters},
              {"floors", floors},
              {"rooms", listed_rooms},
              {"tethers", tethers}}
             .dump(2) +
         "\n";
}

}  // namespace gurney::report
