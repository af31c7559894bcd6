#include "studies/study/job/items_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

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
  return items.size() == tables.size() ? items : std::vector<JobItem>{};
}

}  // namespace gurney::study
