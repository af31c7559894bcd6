#include "equipment/catalogue/item_description.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "engine/base/units.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/quantity.h"

namespace gurney::equipment {
namespace {

using config::Range;
using config::Table;

constexpr int kMostPayloads = 100;

void read_chassis(Quantities in, ItemDescription& item) {
  item.material = in.table().text("material", "");
  item.chassis_mass = in.number("mass_kg", Range::positive());
  item.chassis_center_of_mass = in.vector_mm("center_of_mass_mm", Range::any());
  const bool box = in.table().has("inertia_box_mm");
  if (box && in.table().has("inertia_kg_m2"))
    in.table().note("inertia_box_mm", ": must not go with inertia_kg_m2; one of them states it");
  if (!box && !in.table().has("inertia_kg_m2")) {
    in.table().note("inertia_box_mm", ": missing; must be given, or inertia_kg_m2 in its place");
    in.table().has("inertia_products_kg_m2");  // is known, though useless alone
    return;
  }
  if (box) {
    item.chassis_inertia =
        solid_box_inertia(item.chassis_mass, in.vector_mm("inertia_box_mm", Range::positive()));
    return;
  }
  const Vector3 moments = in.vector("inertia_kg_m2", Range::positive(), Vector3::Ones());
  const Vector3 products = in.vector("inertia_products_kg_m2", Range::any(), Vector3::Zero());
  Matrix3& inertia = item.chassis_inertia;
  inertia = moments.asDiagonal();
  inertia(0, 1) = inertia(1, 0) = products[0];
  inertia(0, 2) = inertia(2, 0) = products[1];
  inertia(1, 2) = inertia(2, 1) = products[2];
}

/// Casters named in one item. Mistakes of a file are noted once; a file is read once, or in a draw
/// for each place, which is a part of its own.
class CasterTypes {
 public:
  CasterType read(Table& place, const std::string& place_name) {
    const bool inline_type = place.has("inline");
    if (inline_type == place.has("type"))
      place.note("type", ": must name a caster, or a table 'inline' must describe it, not both");
    if (inline_type) {
      auto table = place.table("inline");
      return table ? read_caster_type(*table) : CasterType{};
    }
    if (!place.has("type")) return {};
    std::vector<Assumption> choice;
    const std::string name = Quantities(place, choice).text("type");
    CasterType type = load(place, name, place_name);
    add_assumptions(type.assumptions, choice);
    return type;
  }

 private:
  CasterType load(Table& place, const std::string& name, const std::string& place_name) {
    std::string file;
    try {
      file = find_data(DataKind::kCaster, name, place.document().path());
    } catch (const Error& error) {
      place.note("type", " = \"" + name + "\": " + error.what());
      return {};
    }
    std::optional<Draw> draw = place.document().draw();
    if (draw) draw = draw->of_part(place_name);
    const std::string part = draw ? draw->full_name(file) : file;
    const auto known = types_.find(part);
    if (known != types_.end()) return known->second;
    CasterType type;
    try {
      type = load_caster_type(file, draw);
    } catch (const Error& error) {
      if (mistakes_.insert(error.what()).second) place.document().note(error);
    }
    return types_[part] = type;
  }

  std::map<std::string, CasterType> types_;
  std::set<std::string> mistakes_;
};

CasterPlace read_place(Table table, std::size_t index, CasterTypes& types,
                       std::vector<Assumption>& assumptions) {
  CasterPlace place;
  Quantities in(table, assumptions);
  place.name = table.text("name", fmt::format("caster {}", index + 1));
  place.type = types.read(table, place.name);
  place.where = table.where("position_mm");
  place.mount = in.vector_mm("position_mm", Range::any());
  place.heading = in.number("heading_deg", Range::any(), 0.0) * kRadiansPerDegree;
  place.stated_heading = in.stated("heading_deg") * kRadiansPerDegree;
  place.swivels = table.boolean("swivels", true);
  place.brake_on = in.flag("brake", false);
  place.swivel_locked = in.flag("swivel_lock", false);
  if (!place.swivels && (place.swivel_locked || table.is_table("swivel_lock")))
    table.note("swivel_lock", ": has no effect: the caster does not swivel (swivels = false)");
  return place;
}

PayloadKind read_payload(Table table) {
  PayloadKind payload;
  Quantities in(table, payload.assumptions);
  payload.name = table.text("name");
  payload.mass = in.number("mass_kg", Range::positive());
  payload.size = in.vector_mm("size_mm", Range::positive());
  payload.position = in.vector_mm("position_mm", Range::any());
  payload.count = table.integer("count", 0, kMostPayloads, 0);
  return payload;
}

/// Names must differ, so that jobs and results can tell the parts apart.
template <typename Part>
void check_names(const std::vector<Part>& parts, const std::string& key, Table& table) {
  for (std::size_t i = 1; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (parts[i].name == parts[j].name)
        table.note(key, fmt::format("[{}].name = \"{}\": must differ from the name of {}[{}]", i,
                                    parts[i].name, key, j));
}

}  // namespace

ItemDescription read_item(Table table) {
  ItemDescription item;
  item.file = table.document().path();
  item.name = table.text("name");
  item.description = table.text("description", "");
  if (auto chassis = table.table("chassis"))
    read_chassis(Quantities(*chassis, item.assumptions), item);
  else if (!table.has("chassis"))
    table.note("chassis", ": missing; must be a table [" + table.name_of("chassis") + "]");

  for (Table& box : table.tables("shape")) {
    Quantities in(box, item.assumptions);
    item.shape.push_back(
        {in.vector_mm("center_mm", Range::any()), in.vector_mm("size_mm", Range::positive())});
  }
  if (item.shape.empty()) table.note("shape", ": must have at least one box [[shape]]");

  CasterTypes types;
  for (Table& place : table.tables("caster"))
    item.casters.push_back(read_place(place, item.casters.size(), types, item.assumptions));
  if (item.casters.size() > EquipmentModel::kMaxCasters)
    table.note("caster", fmt::format(": {} casters; must be 0 to {} tables [[caster]]",
                                     item.casters.size(), EquipmentModel::kMaxCasters));
  if (auto contact = table.table("contact"))
    item.contact = read_item_contact(*contact);
  else if (!table.has("contact") && item.casters.empty())
    table.note("contact", ": missing; an item without casters needs a table [" +
                              table.name_of("contact") + "], how it meets the floor");
  for (Table& payload : table.tables("payload")) item.payloads.push_back(read_payload(payload));
  for (Table& point : table.tables("marked_point")) {
    Quantities in(point, item.assumptions);
    item.marked_points.push_back({point.text("name"), in.vector_mm("position_mm", Range::any())});
  }
  check_names(item.casters, "caster", table);
  check_names(item.payloads, "payload", table);
  check_names(item.marked_points, "marked_point", table);
  return item;
}

}  // namespace gurney::equipment
