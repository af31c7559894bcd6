#include "studies/study/job/items_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "studies/study/job/excitation_reader.h"
#include "studies/study/job/item_reader.h"

namespace gurney::study {
namespace {

using config::Table;

std::vector<Table> item_tables(Table& root) {
  if (root.is_array("item")) {
    const std::size_t mistakes = root.document().mistakes();
    std::vector<Table> tables = root.tables("item");
    if (tables.empty() && root.document().mistakes() == mistakes)
      root.note("item", ": must be tables [[item]], 1 or more");
    return tables;
  }
  if (auto table = root.table("item")) return {*table};
  if (!root.has("item"))
    root.note("item", ": missing; must be a table [item], or tables [[item]] for several");
  return {};
}

/// The equipment's name in the catalogue, or that of its file.
std::string equipment_name(Table& item) {
  if (item.is_table("inline")) {
    Table table = *item.table("inline");
    return table.is_text("name") ? table.text("name") : "item";
  }
  return item.is_text("equipment") ? std::filesystem::path(item.text("equipment")).stem().string()
                                   : "item";
}

/// Stated names come first: a name made from the equipment's gives way to them.
std::vector<std::string> read_names(std::vector<Table>& items, equipment::UniqueNames& names) {
  std::vector<std::string> result(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].has("name")) names.take(items[i], result[i] = items[i].text("name"));
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].has("name")) continue;
    const std::string base = equipment_name(items[i]);
    result[i] = base;
    for (int number = 2; names.has(result[i]); ++number)
      result[i] = fmt::format("{} {}", base, number);
    names.take(items[i], result[i]);
  }
  return result;
}

/// What acts on the item, and how it moves at the start.
void read_acting(Table& item, PlacedItem& placed, std::vector<equipment::Assumption>& assumptions) {
  read_loads(item, assumptions, placed.loads);
  if (auto fixture = item.table("fixture")) placed.fixture = read_fixture(*fixture, assumptions);
  if (auto initial = item.table("initial")) read_initial(*initial, assumptions, placed.initial);
}

/// Notes each of these keys that is there: a job of several items has it with one of them.
void note_without_item(Table& table, const std::vector<const char*>& keys, const char* form) {
  for (const char* key : keys)
    if (table.has(key))
      table.note(key, fmt::format(": must be with one of the items, {} below its [[item]]",
                                  fmt::format(fmt::runtime(form), key)));
}

/// Notes a table that both the job and its item have.
void note_twice(Table& root, Table& item, const char* key) {
  if (root.has(key) && item.has(key))
    root.note(key, fmt::format(": must not be given beside item.{}", key));
}

}  // namespace

std::vector<JobItem> read_items(Table& root,
                                const std::optional<equipment::FloorCovering>& covering,
                                equipment::UniqueNames& names, Job& job) {
  std::vector<Table> tables = item_tables(root);
  const bool several = root.is_array("item");
  const std::vector<std::string> item_names = read_names(tables, names);
  job.scene.items.resize(std::max<std::size_t>(1, tables.size()));
  std::vector<JobItem> items;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    PlacedItem& placed = job.scene.items[i];
    placed.name = item_names[i];
    if (several && job.draw)
      root.document().set_draw_of(fmt::format("item[{}]", i), job.draw->of_part(placed.name));
    equipment::ItemOptions options;
    options.floor = covering;
    Remarks remarks;
    std::optional<equipment::LoadedItem> item =
        read_job_item(tables[i], options, placed.initial, job.assumptions, remarks);
    job.warnings.insert(job.warnings.end(), remarks.warnings.begin(), remarks.warnings.end());
    job.without_effect.insert(job.without_effect.end(), remarks.without_effect.begin(),
                              remarks.without_effect.end());
    read_acting(tables[i], placed, job.assumptions);
    if (!item) continue;
    JobItem& of_job = items.emplace_back(JobItem{tables[i], {}});
    if (item->states_contact)
      for (const MaterialPair& pair : item->pairs) of_job.contacts.push_back(pair.constants);
    placed.model = std::move(item->model);
    for (const std::string& warning : item->warnings)
      job.warnings.push_back(several ? placed.name + ": " + warning : warning);
    equipment::add_assumptions(job.assumptions, item->assumptions);
  }
  root.document().set_draw_of("", job.draw);
  if (tables.size() == 1)
    for (const char* key : {"fixture", "initial"}) note_twice(root, tables.front(), key);
  return items.size() == tables.size() ? items : std::vector<JobItem>{};
}

void read_acting_at_top(Table& root, Job& job) {
  const bool several = job.scene.items.size() > 1;
  PlacedItem none;
  PlacedItem& only = several ? none : job.scene.items.front();
  if (auto excitation = root.table("excitation")) {
    read_loads(*excitation, job.assumptions, only.loads);
    if (several)
      note_without_item(*excitation, {"force", "drop_weight", "string_potentiometer", "blocks"},
                        "[[item.{}]]");
  }
  if (auto fixture = root.table("fixture")) only.fixture = read_fixture(*fixture, job.assumptions);
  if (auto initial = root.table("initial")) read_initial(*initial, job.assumptions, only.initial);
  if (several) note_without_item(root, {"fixture", "initial"}, "[item.{}]");
}

}  // namespace gurney::study
