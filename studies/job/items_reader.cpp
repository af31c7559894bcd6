#include "studies/job/items_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>

#include "studies/job/excitation_reader.h"
#include "studies/job/item_reader.h"

namespace gurney::study {
namespace {

using config::Table;

std::vector<Table> item_tables(Table& root) {
  if (root.is_array("item")) {
    const std::size_t errors = root.document().errors();
    std::vector<Table> tables = root.tables("item");
    if (tables.empty() && root.document().errors() == errors)
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

/// Stated names come first: one formed from the equipment's avoids them.
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
void read_acting(Table& item, equipment::Uncertain<PlacedItem>& acting) {
  read_loads(item, acting);
  if (auto fixture = item.table("fixture")) read_fixture(*fixture, acting);
  if (auto initial = item.table("initial")) read_initial(*initial, acting);
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

/// What a step needs of one item's table.
struct ItemStep {
  std::size_t index = 0;
  bool several = false;
  config::Spot description{};
  Remarks remarks{};
};

template <typename T>
void append(std::vector<T>& list, const std::vector<T>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

bool has_a_place(const std::string& line, const equipment::ItemDescription& description) {
  return std::ranges::any_of(description.casters, [&](const equipment::CasterPlace& caster) {
    return !caster.where.empty() && line.starts_with(caster.where);
  });
}

/// Errors in how an item is put together: at its casters, else where the job names it.
void note_lines(const Error& error, const equipment::ItemDescription& description,
                const config::Spot& spot, equipment::Sampler& of) {
  std::istringstream lines(error.what());
  for (std::string line; std::getline(lines, line);)
    if (has_a_place(line, description))
      of.error(Error(line));
    else
      of.error(spot, ": " + line);
}

void place(JobItem item, const ItemStep& step, JobParts& job, equipment::Sampler& of) {
  PlacedItem& placed = job.scene.items[step.index];
  append(job.warnings, step.remarks.warnings);
  item.options.floor = job.covering;
  try {
    equipment::LoadedItem loaded = assemble_item(item.description, item.options);
    if (loaded.states_contact)
      for (const MaterialPair& pair : loaded.pairs)
        job.item_contacts[step.index].push_back(pair.constants);
    placed.model = std::move(loaded.model);
    for (const std::string& warning : loaded.warnings)
      job.warnings.push_back(step.several ? placed.name + ": " + warning : warning);
    add_assumptions(job.assumptions, loaded.assumptions);
  } catch (const Error& error) {
    note_lines(error, item.description, step.description, of);
  }
}

void read_one(Table& table, ItemStep step, JobReading& job) {
  config::Document& document = table.document();
  const std::size_t errors = document.errors();
  const equipment::Uncertain<JobItem> item = read_job_item(table, step.remarks);
  step.description = description_spot(table);
  equipment::Uncertain<PlacedItem> acting;
  read_acting(table, acting);
  const bool complete = document.errors() == errors;
  job.add(document, [item, acting, step, complete](JobParts& of_draw, equipment::Sampler& of) {
    PlacedItem& placed = of_draw.scene.items[step.index];
    const equipment::Sampler own =
        step.several ? of.of_element(fmt::format("item[{}]", step.index), placed.name) : of;
    JobItem sampled = item.sample(own);
    placed.initial = sampled.initial;
    acting.apply(placed, own);
    append(of_draw.without_effect, step.remarks.without_effect);
    if (complete) place(std::move(sampled), step, of_draw, of);
  });
}

}  // namespace

std::vector<Table> read_items(Table& root, equipment::UniqueNames& names, JobReading& job) {
  std::vector<Table> tables = item_tables(root);
  job.add([item_names = read_names(tables, names)](JobParts& of_draw, equipment::Sampler&) {
    of_draw.scene.items.resize(std::max<std::size_t>(1, item_names.size()));
    of_draw.item_contacts.resize(of_draw.scene.items.size());
    for (std::size_t i = 0; i < item_names.size(); ++i) of_draw.scene.items[i].name = item_names[i];
  });
  const std::size_t errors = root.document().errors();
  const bool several = root.is_array("item");
  for (std::size_t i = 0; i < tables.size(); ++i)
    read_one(tables[i], {.index = i, .several = several}, job);
  if (tables.size() == 1)
    for (const char* key : {"fixture", "initial"}) note_twice(root, tables.front(), key);
  return root.document().errors() == errors ? tables : std::vector<Table>{};
}

void read_acting_at_top(Table& root, JobReading& job) {
  const bool several = job.stated().scene.items.size() > 1;
  equipment::Uncertain<PlacedItem> only;
  if (auto excitation = root.table("excitation")) {
    read_loads(*excitation, only);
    if (several)
      note_without_item(*excitation, {"force", "drop_weight", "string_potentiometer", "blocks"},
                        "[[item.{}]]");
  }
  if (auto fixture = root.table("fixture")) read_fixture(*fixture, only);
  if (auto initial = root.table("initial")) read_initial(*initial, only);
  if (several) {
    note_without_item(root, {"fixture", "initial"}, "[item.{}]");
    return;
  }
  job.add([only](JobParts& of_draw, equipment::Sampler& of) {
    only.apply(of_draw.scene.items.front(), of);
  });
}

}  // namespace gurney::study
