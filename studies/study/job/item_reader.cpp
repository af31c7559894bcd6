#include "studies/study/job/item_reader.h"

#include <algorithm>
#include <sstream>

#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "equipment/catalogue/quantity.h"
#include "studies/study/job/caster_options.h"
#include "studies/study/job/load_named.h"

namespace gurney {
namespace {

using config::Range;
using config::Table;

constexpr int kMostPayloads = 100;

std::optional<ItemDescription> read_description(Table& item) {
  ItemSelection selection{item.texts("variant"), item.document().draw()};
  if (item.has("equipment") == item.has("inline")) {
    item.note("equipment", ": must name an item, or [item.inline] must describe it, not both");
    return {};
  }
  if (auto table = item.table("inline")) {
    if (!selection.variants.empty())
      item.note("variant", ": only an item with a file of its own has variants");
    return read_item(*table);
  }
  return load_named(item, "equipment", DataKind::kItem, [&](const std::string& file) {
    const std::string unknown = unknown_variant(selection.variants, variant_names(file));
    if (!unknown.empty()) {
      item.note("variant", ": " + unknown);
      selection.variants.clear();
    }
    return load_item_description(file, selection);
  });
}

/// The caster named in the job at every place; in a draw each place is a part of its own.
void read_casters(Table& item, ItemDescription* description, ItemOptions& options) {
  const auto load = [&](const std::optional<Draw>& draw) {
    return load_named(item, "casters", DataKind::kCaster,
                      [&](const std::string& file) { return load_caster_type(file, draw); });
  };
  const std::optional<Draw>& draw = item.document().draw();
  const std::optional<CasterType> as_it_is = load({});
  if (!draw) options.caster = as_it_is;
  if (!draw || !as_it_is || description == nullptr) return;
  for (CasterPlace& place : description->casters)
    if (const auto drawn = load(draw->of_part(place.name))) place.type = *drawn;
}

void note_keys_of_casters(Table& item, const ItemDescription& description) {
  for (const char* key : {"casters", "headings_deg", "brakes", "swivel_locks"})
    if (item.has(key)) item.note(key, ": " + description.name + " has no casters");
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

bool has_a_place(const std::string& line, const ItemDescription& description) {
  return std::ranges::any_of(description.casters, [&](const CasterPlace& caster) {
    return !caster.where.empty() && line.starts_with(caster.where);
  });
}

}  // namespace

std::optional<FloorCovering> read_floor_covering(Table& floor) {
  std::optional<Draw> draw = floor.document().draw();
  if (draw) draw = draw->of_part("floor");
  return load_named(floor, "covering", DataKind::kFloor,
                    [&](const std::string& file) { return load_floor_covering(file, draw); });
}

std::optional<LoadedItem> read_job_item(Table& item, ItemOptions& options, InitialMotion& initial,
                                        std::vector<Assumption>& assumptions, Remarks& remarks) {
  const std::size_t mistakes_of_others = item.document().mistakes();
  Quantities in(item, assumptions);
  const std::vector<double> position = in.plane("position_m", Range::any(), {0, 0});
  initial.position = Vector3(position[0], position[1], 0);
  initial.yaw = in.number("yaw_deg", Range::any(), 0.0) * kRadiansPerDegree;
  for (const char* key : {"headings_deg", "brakes", "swivel_locks", "payloads"}) item.has(key);

  std::optional<ItemDescription> description = read_description(item);
  read_casters(item, description ? &*description : nullptr, options);
  if (!description) return {};
  if (description->casters.empty()) {
    note_keys_of_casters(item, *description);
  } else {
    read_caster_options(in, *description, options, remarks);
  }
  options.payloads = read_payloads(item, *description);
  if (item.document().mistakes() > mistakes_of_others) return {};
  try {
    return assemble_item(*description, options);
  } catch (const Error& error) {
    std::istringstream lines(error.what());
    for (std::string line; std::getline(lines, line);)
      if (has_a_place(line, *description))
        item.document().note(Error(line));
      else
        item.note(item.has("inline") ? "inline" : "equipment", ": " + line);
    return {};
  }
}

}  // namespace gurney
