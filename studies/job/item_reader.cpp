#include "studies/job/item_reader.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "equipment/catalogue/quantity.h"
#include "studies/job/caster_options.h"
#include "studies/job/load_named.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

constexpr int kMaxPayloads = 100;

std::optional<equipment::Uncertain<equipment::ItemDescription>> read_description(Table& item) {
  std::vector<std::string> variants = item.texts("variant", true);  // []: as it is
  if (item.has("equipment") == item.has("inline")) {
    item.note("equipment", ": must name an item, or [item.inline] must describe it, not both");
    return {};
  }
  if (auto table = item.table("inline")) {
    if (!variants.empty())
      item.note("variant", ": only an item with a file of its own has variants");
    return equipment::read_item(*table);
  }
  return load_named(item, "equipment", equipment::DataKind::kItem, [&](const std::string& file) {
    const std::string unknown =
        equipment::unknown_variant(variants, equipment::variant_names(file));
    if (!unknown.empty()) {
      item.note("variant", ": " + unknown);
      variants.clear();
    }
    return equipment::load_item_description(file, variants);
  });
}

/// The caster named in the job at every place; in a draw each place is a part of its own.
void read_casters(Table& item, equipment::Uncertain<JobItem>& result) {
  auto type =
      load_named(item, "casters", equipment::DataKind::kCaster, equipment::load_caster_type);
  if (!type) return;
  result.add([type = *std::move(type)](JobItem& of_draw, equipment::Sampler& of) {
    for (equipment::CasterPlace& place : of_draw.description.casters)
      place.type = type.sample(of.of_part(place.name));
  });
}

void note_keys_of_casters(Table& item, const equipment::ItemDescription& description) {
  for (const char* key : {"casters", "headings_deg", "brakes", "swivel_locks"})
    if (item.has(key)) {
      item.note(key, ": " + description.name + " has no casters");
      item.set_aside(key);
    }
}

std::map<std::string, int> read_payloads(Table& item,
                                         const equipment::ItemDescription& description) {
  std::map<std::string, int> counts;
  auto table = item.table("payloads");
  if (!table) return counts;
  std::vector<std::string> known;
  for (const equipment::PayloadKind& kind : description.payloads) known.push_back(kind.name);
  for (const std::string& name : table->keys()) {
    counts[name] = table->integer(name, 0, kMaxPayloads);
    if (std::find(known.begin(), known.end(), name) == known.end())
      table->note(
          name, ": " + description.name + " has no such payload" + config::suggestion(name, known));
  }
  return counts;
}

}  // namespace

equipment::Uncertain<JobItem> read_job_item(Table& item, Remarks& remarks) {
  equipment::Uncertain<JobItem> result;
  equipment::Quantities in(item);
  result.set([](JobItem& of_draw) -> Vector3& { return of_draw.initial.position; },
             in.plane("position_m", Range::any()));
  result.set([](JobItem& of_draw) -> double& { return of_draw.initial.yaw; },
             in.angle_deg("yaw_deg", Range::any(), 0.0));
  std::optional<equipment::Uncertain<equipment::ItemDescription>> found = read_description(item);
  const bool described = found.has_value();
  if (described) result.set(&JobItem::description, *std::move(found));
  read_casters(item, result);
  if (!described) {
    for (const char* key : {"headings_deg", "brakes", "swivel_locks", "payloads"})
      item.set_aside(key);
    return result;
  }
  const equipment::ItemDescription& description = result.stated().description;
  if (description.casters.empty())
    note_keys_of_casters(item, description);
  else
    read_caster_options(in, result, remarks);
  result.add([counts = read_payloads(item, description)](JobItem& of_draw, equipment::Sampler&) {
    of_draw.options.payloads = counts;
  });
  return result;
}

}  // namespace gurney::study
