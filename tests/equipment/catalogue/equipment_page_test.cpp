#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "engine/base/units.h"
#include "engine/config/document.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"
#include "equipment/catalogue/support.h"

// docs/equipment.md against the files: every row is made here from the catalogue, up to its words.
namespace gurney::equipment {
namespace {

using config::Node;

/// Quantities of a file that hold numbers, and how many of them have a source. What a variant
/// changes is not counted.
struct Provenance {
  int sourced = 0;
  int all = 0;
};

void count(const Node& node, Provenance& found) {
  if (node.key == "variant") return;
  const Node* value = node.find("value");
  if (value != nullptr && value->kind != Node::Kind::kText) {
    ++found.all;
    if (node.find("source") != nullptr) ++found.sourced;
  }
  for (const Node& element : node.elements) count(element, found);
}

std::string provenance_of(const std::string& file) {
  const config::Document document(file);
  Provenance found;
  count(document.tree(), found);
  return fmt::format("{} of {}", found.sourced, found.all);
}

std::string text_of(const std::string& file, const char* key) {
  const config::Document document(file);
  return document.tree().find(key)->text;
}

/// `2 pu_125, 2 rigid_125 (rigid)`.
std::string casters_of(const ItemDescription& item) {
  if (item.casters.empty()) return "none";
  std::vector<std::pair<std::string, int>> kinds;
  for (const CasterPlace& caster : item.casters) {
    const std::string kind = caster.type.name + (caster.swivels ? "" : " (rigid)");
    const auto known = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const auto& each) { return each.first == kind; });
    if (known == kinds.end())
      kinds.emplace_back(kind, 1);
    else
      ++known->second;
  }
  std::string list;
  for (const auto& [kind, number] : kinds)
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", number, kind);
  return list;
}

std::string parked(const ItemDescription& item) {
  const auto brakes = std::count_if(item.casters.begin(), item.casters.end(),
                                    [](const CasterPlace& caster) { return caster.brake_on; });
  const auto locks = std::count_if(item.casters.begin(), item.casters.end(),
                                   [](const CasterPlace& caster) { return caster.swivel_locked; });
  if (locks > 0) return fmt::format("{} locked", locks);
  if (item.casters.empty()) return "stands";
  return brakes > 0 ? fmt::format("{} braked", brakes) : "free";
}

/// Length, width and height above the floor, over shapes and mounts [mm].
std::string size_of(const EquipmentModel& item) {
  Vector3 low = Vector3::Zero(), high = Vector3::Zero();
  const auto include = [&](const Vector3& from, const Vector3& to) {
    low = low.cwiseMin(from);
    high = high.cwiseMax(to);
  };
  for (const BodyShape& box : item.shape)
    include(box.center - box.size / 2, box.center + box.size / 2);
  for (const Caster& caster : item.casters) include(caster.mount, caster.mount);
  const Vector3 size = kMillimetersPerMeter * (high - low);
  return fmt::format("{:.0f} x {:.0f} x {:.0f}", size.x(), size.y(), size.z());
}

std::string item_row(const std::string& name) {
  const std::string file = find_data(DataKind::kItem, name, "");
  const ItemDescription description = load_item_description(file).stated();
  ItemOptions released;
  released.swivel_locks.assign(description.casters.size(), false);
  const EquipmentModel model = assemble_item(description, released).model;
  const Stability stability = stability_of(model);
  return fmt::format(
      "| `{}` | {} | {:.1f} | {} | {} | {} | {:.2f} | {:.0f} | {} |", name, description.name,
      whole_item(model).mass, size_of(model), casters_of(description), parked(description),
      stability.base / stability.height, stability.tilt / kRadiansPerDegree, provenance_of(file));
}

std::string torque(double value) { return value > 0 ? fmt::format("{:.0f}", value) : "none"; }

std::string caster_row(const std::string& name) {
  const std::string file = find_data(DataKind::kCaster, name, "");
  const CasterType type = load_caster_type(file).stated();
  const Caster& c = type.properties;
  return fmt::format(
      "| `{}` | {:.0f} | {:.0f} | {:.0f} | {:.1f} | {:.3f} | {:.0f} | {} | {} | {} |", name,
      2 * kMillimetersPerMeter * c.wheel_radius, kMillimetersPerMeter * c.wheel_width,
      kMillimetersPerMeter * c.height, kMillimetersPerMeter * c.trail,
      c.tread.rolling_friction_length / c.wheel_radius, kMillimetersPerMeter * c.tread.patch_width,
      torque(type.brake_torque), torque(type.swivel_lock_torque), provenance_of(file));
}

std::string floor_row(const std::string& name) {
  const std::string file = find_data(DataKind::kFloor, name, "");
  const FloorCovering floor = load_floor_covering(file).stated();
  return fmt::format("| `{}` | {} | {:.1f} | {:.1f} | {} |", name, text_of(file, "name"),
                     floor.rolling_resistance_factor, floor.friction_factor, provenance_of(file));
}

/// Rows of the page below `## section` that start with "| `".
std::vector<std::string> rows_of_page(const std::string& section) {
  std::ifstream page(GURNEY_SOURCE_DIR "/docs/equipment.md");
  std::vector<std::string> rows;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("## ", 0) == 0) inside = line == "## " + section;
    if (inside && line.rfind("| `", 0) == 0) rows.push_back(line);
  }
  return rows;
}

bool is_row_of(const std::string& row, const std::string& name) {
  return row.starts_with("| `" + name + "` |");
}

/// Every name has one row, in the catalogue's order, that starts as the files say and then has
/// words.
void compare(const std::string& section, DataKind kind, std::string (*row_of)(const std::string&)) {
  const std::vector<std::string> rows = rows_of_page(section);
  const std::vector<std::string> names = catalogue_names(kind);
  for (const std::string& name : names)
    if (std::ranges::none_of(rows, [&](const std::string& row) { return is_row_of(row, name); }))
      ADD_FAILURE() << "\"" << section << "\" has no row " << row_of(name) << " ... (and words)";
  ASSERT_EQ(rows.size(), names.size()) << section;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string expected = row_of(names[i]);
    EXPECT_EQ(rows[i].substr(0, expected.size()), expected);
    EXPECT_GT(rows[i].size(), expected.size() + 10) << "no words in the row of " << names[i];
  }
}

TEST(CataloguePage, HasEveryItemWithItsNumbers) { compare("Items", DataKind::kItem, item_row); }

TEST(CataloguePage, HasEveryCasterWithItsNumbers) {
  compare("Casters", DataKind::kCaster, caster_row);
}

TEST(CataloguePage, HasEveryFloorWithItsNumbers) {
  compare("Floor coverings", DataKind::kFloor, floor_row);
}

}  // namespace
}  // namespace gurney::equipment
