#include "studies/job/item_reader.h"

#include <algorithm>
#include <sstream>

#include "engine/base/config/nearest_name.h"
#include "engine/base/units.h"
#include "equipment/catalogue.h"
#include "equipment/quantity.h"

namespace gurney {
namespace {

using config::Range;
using config::Table;

constexpr int kMostPayloads = 100;

/// Loads what `key` names; a mistake in the name is noted here, mistakes in the file after ours.
template <typename Load>
auto load_named(Table& table, const std::string& key, DataKind kind, Load load)
    -> std::optional<decltype(load(std::string()))> {
  if (!table.has(key)) return {};
  const std::string name = table.text(key);
  if (!table.is_text(key)) return {};
  std::string file;
  try {
    file = find_data(kind, name, table.document().path());
  } catch (const Error& error) {
    table.note(key, " = \"" + name + "\": " + error.what());
    return {};
  }
  try {
    return load(file);
  } catch (const Error& error) {
    table.document().note(error);
    return {};
  }
}

std::optional<ItemDescription> read_description(Table& item) {
  if (item.has("equipment") == item.has("inline")) {
    item.note("equipment", ": must name an item, or [item.inline] must describe it, not both");
    return {};
  }
  if (auto table = item.table("inline")) return read_item(*table);
  return load_named(item, "equipment", DataKind::kItem, load_item_description);
}

std::vector<double> read_headings(Table& item, std::size_t casters) {
  std::vector<double> headings;
  if (item.is_array("headings_deg"))
    headings = item.numbers("headings_deg", Range::any(), casters);
  else if (item.has("headings_deg"))
    headings.assign(casters, item.number("headings_deg", Range::any()));
  for (double& heading : headings) heading *= kRadiansPerDegree;
  return headings;
}

std::vector<bool> read_flags(Table& item, const std::string& key, std::size_t casters) {
  if (item.is_array(key)) return item.booleans(key, casters);
  if (item.has(key)) return std::vector<bool>(casters, item.boolean(key));
  return {};
}

std::map<std::string, int> read_payloads(Table& item, const ItemDescription& description) {
  std::map<std::string, int> counts;
  auto table = item.table("payloads");
  if (!table) return counts;
  std::vector<std::string> known;
  for (const PayloadKind& kind : description.payloads) known.push_back(kind.name);
  for (const std::string& name : table->keys()) {
    counts[name] = table->integer(name, 0, kMostPayloads);
    if (std::find(known.begin(), known.end(), name) == known.end())
      table->note(
          name, ": " + description.name + " has no such payload" + config::suggestion(name, known));
  }
  return counts;
}

}  // namespace

std::optional<FloorCovering> read_floor_covering(Table& floor) {
  return load_named(floor, "covering", DataKind::kFloor, load_floor_covering);
}

std::optional<LoadedItem> read_job_item(Table& item, ItemOptions& options, InitialMotion& initial,
                                        std::vector<Assumption>& assumptions) {
  Quantities in(item, assumptions);
  const std::vector<double> position = item.numbers("position_m", Range::any(), 2, {{0, 0}});
  initial.position = Vector3(position[0], position[1], 0);
  initial.yaw = in.number("yaw_deg", Range::any(), 0.0) * kRadiansPerDegree;
  options.caster = load_named(item, "casters", DataKind::kCaster, load_caster_type);
  for (const char* key : {"headings_deg", "brakes", "swivel_locks", "payloads"}) item.has(key);

  const std::optional<ItemDescription> description = read_description(item);
  if (!description) return {};
  const std::size_t casters = description->casters.size();
  options.headings = read_headings(item, casters);
  options.brakes = read_flags(item, "brakes", casters);
  options.swivel_locks = read_flags(item, "swivel_locks", casters);
  options.payloads = read_payloads(item, *description);
  if (!item.document().clean()) return {};
  try {
    return assemble_item(*description, options);
  } catch (const Error& error) {
    std::istringstream lines(error.what());
    for (std::string line; std::getline(lines, line);)
      item.note(item.has("inline") ? "inline" : "equipment", ": " + line);
    return {};
  }
}

}  // namespace gurney
