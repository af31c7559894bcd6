#include "studies/study/job/item_reader.h"

#include <algorithm>
#include <sstream>

#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "equipment/catalogue/quantity.h"
#include "studies/study/job/caster_options.h"
#include "studies/study/job/load_named.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

constexpr int kMostPayloads = 100;

std::optional<equipment::ItemDescription> read_description(Table& item) {
  equipment::ItemSelection selection{item.texts("variant"), item.document().draw()};
  if (item.has("equipment") == item.has("inline")) {
    item.note("equipment", ": must name an item, or [item.inline] must describe it, not both");
    return {};
  }
  if (auto table = item.table("inline")) {
    if (!selection.variants.empty())
      item.note("variant", ": only an item with a file of its own has variants");
    return equipment::read_item(*table);
  }
  return load_named(item, "equipment", equipment::DataKind::kItem, [&](const std::string& file) {
    const std::string unknown =
        equipment::unknown_variant(selection.variants, equipment::variant_names(file));
    if (!unknown.empty()) {
      item.note("variant", ": " + unknown);
      selection.variants.clear();
    }
    return equipment::load_item_description(file, selection);
  });
}

/// The caster named in the job at every place; in a draw each place is a part of its own.
void read_casters(Table& item, equipment::ItemDescription* description,
                  equipment::ItemOptions& options) {
  const auto load = [&](const std::optional<Draw>& draw) {
    return load_named(item, "casters", equipment::DataKind::kCaster, [&](const std::string& file) {
      return equipment::load_caster_type(file, draw);
    });
  };
  const std::optional<Draw>& draw = item.document().draw();
  const std::optional<equipment::CasterType> as_it_is = load({});
  if (!draw) options.caster = as_it_is;
  if (!draw || !as_it_is || description == nullptr) return;
  for (equipment::CasterPlace& place : description->casters)
    if (const auto drawn = load(draw->of_part(place.name))) place.type = *drawn;
}

void note_keys_of_casters(Table& item, const equipment::ItemDescription& description) {
  for (const char* key : {"casters", "headings_deg", "brakes", "swivel_locks"})
    if (item.has(key)) item.note(key, ": " + description.name + " has no casters");
}

std::map<std::string, int> read_payloads(Table& item,
                                         const equipment::ItemDescription& description) {
  std::map<std::string, int> counts;
  auto table = item.table("payloads");
  if (!table) return counts;
  std::vector<std::string> known;
  for (const equipment::PayloadKind& kind : description.payloads) known.push_back(kind.name);
  for (const std::string& name : table->keys()) {
    counts[name] = table->integer(name, 0, kMostPayloads);
    if (std::find(known.begin(), known.end(), name) == known.end())
      table->note(
          name, ": " + description.name + " has no such payload" + config::suggestion(name, known));
  }
  return counts;
}

bool has_a_place(const std::string& line, const equipment::ItemDescription& description) {
  return std::ranges::any_of(description.casters, [&](const equipment::CasterPlace& caster) {
    return !caster.where.empty() && line.starts_with(caster.where);
  });
}

}  // namespace

std::optional<equipment::FloorCovering> read_floor_covering(Table& floor) {
  std::optional<Draw> draw = floor.document().draw();
  if (draw) draw = draw->of_part("floor");
  return load_named(floor, "covering", equipment::DataKind::kFloor, [&](const std::string& file) {
    return equipment::load_floor_covering(file, draw);
  });
}

std::optional<equipment::LoadedItem> read_job_item(Table& item, equipment::ItemOptions& options,
                                                   InitialMotion& initial,
                                                   std::vector<equipment::Assumption>& assumptions,
                                                   Remarks& remarks) {
  const std::size_t mistakes_of_others = item.document().mistakes();
  equipment::Quantities in(item, assumptions);
  const std::vector<double> position = in.plane("position_m", Range::any(), {0, 0});
  initial.position = Vector3(position[0], position[1], 0);
  initial.yaw = in.number("yaw_deg", Range::any(), 0.0) * kRadiansPerDegree;
  for (const char* key : {"headings_deg", "brakes", "swivel_locks", "payloads"}) item.has(key);

  std::optional<equipment::ItemDescription> description = read_description(item);
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
    return equipment::assemble_item(*description, options);
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

}  // namespace gurney::study
