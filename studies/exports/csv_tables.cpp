#include "studies/exports/csv_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "engine/base/error.h"
#include "equipment/catalogue/uncertainty.h"
#include "studies/results/hdf5_reader.h"

namespace gurney::study {
namespace {

/// The datasets of a group that have their first dimension in common.
struct Table {
  std::string group, scale;
  std::vector<Hdf5Dataset> datasets;
};

std::string group_of(const std::string& path) { return path.substr(1, path.rfind('/') - 1); }
std::string name_of(const std::string& path) { return path.substr(path.rfind('/') + 1); }

std::vector<Table> tables_of(const Hdf5Reader& file, const std::string& path) {
  std::map<std::pair<std::string, std::string>, Table> tables;
  const std::vector<Hdf5Dataset> datasets = file.datasets();
  std::map<std::string, std::vector<std::uint64_t>> shapes;
  for (const Hdf5Dataset& each : datasets) shapes[each.path] = each.shape;
  for (const Hdf5Dataset& each : datasets) {
    const std::string group = group_of(each.path);
    require(!each.scales.empty() && each.scales.size() == each.shape.size(),
            path + ": " + each.path + " has no dimension scale");
    for (std::size_t i = 0; i < each.scales.size(); ++i) {
      const auto scale = shapes.find("/" + group + "/" + each.scales[i]);
      require(scale != shapes.end() && scale->second == std::vector{each.shape[i]},
              fmt::format("{}: {} is not as long as its dimension scale {}", path, each.path,
                          each.scales[i]));
    }
    Table& table = tables[{group, each.scales.front()}];
    table.group = group;
    table.scale = each.scales.front();
    table.datasets.push_back(each);
  }
  std::vector<Table> result;
  for (auto& [key, table] : tables) {
    const bool axis_only = table.datasets.size() == 1 &&
                           table.datasets[0].path == "/" + table.group + "/" + table.scale;
    if (!axis_only) result.push_back(std::move(table));
  }
  return result;
}

/// What identifies the row comes first, then texts, then numbers.
int order_of(const Table& table, const Hdf5Dataset& each) {
  const std::string name = name_of(each.path);
  if (name == table.scale) return 0;
  if (name == "run") return 1;
  return each.type == "string" ? 2 : 3;
}

std::vector<std::string> cells_of(const Hdf5Reader& file, const Hdf5Dataset& dataset, double unit) {
  std::vector<std::string> cells;
  if (dataset.type == "string")
    for (const std::string& text : file.strings(dataset.path)) cells.push_back(csv_cell(text));
  else
    for (const double value : file.numbers(dataset.path)) cells.push_back(csv_cell(value / unit));
  return cells;
}

/// Cells of a scale as parts of names.
std::vector<std::string> places_of(const Hdf5Reader& file, const Table& table,
                                   const std::string& scale) {
  const std::string path = "/" + table.group + "/" + scale;
  for (const Hdf5Dataset& each : file.datasets())
    if (each.path == path && each.type == "string") return file.strings(path);
  std::vector<std::string> places;
  for (const double value : file.numbers(path)) places.push_back(csv_cell(value));
  return places;
}

struct CsvColumn {
  std::string name, units;
  std::vector<std::string> cells;
};

void add_columns(const Hdf5Reader& file, const Table& table, const Hdf5Dataset& dataset,
                 const UnitSystem& units, std::vector<CsvColumn>& columns) {
  const ReportUnit unit = units.of(dataset.units);
  std::vector<std::string> names{name_of(dataset.path)};
  for (std::size_t i = 1; i < dataset.scales.size(); ++i) {
    std::vector<std::string> longer;
    for (const std::string& name : names)
      for (const std::string& place : places_of(file, table, dataset.scales[i]))
        longer.push_back(name + "." + place);
    names = longer;
  }
  std::vector<std::string> cells = cells_of(file, dataset, unit.in_si);
  if (names.size() == 1) {
    columns.push_back({names[0], unit.name, std::move(cells)});
    return;
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    columns.push_back({names[i], unit.name, {}});
    for (std::size_t at = i; at < cells.size(); at += names.size())
      columns.back().cells.push_back(cells[at]);
  }
}

/// Drawn numbers have each the unit of its key: a column of its own, which a run's file has.
void add_units_of_drawn(const Hdf5Reader& file, std::vector<CsvColumn>& columns) {
  const auto named = [&](const char* name) {
    return std::ranges::find(columns, name, &CsvColumn::name);
  };
  if (named("value") == columns.end() || named("variable") == columns.end()) return;
  named("value")->units = "see unit";
  if (named("unit") != columns.end()) return;
  CsvColumn units{"unit", "1", {}};
  for (const std::string& variable : file.strings("/drawn/variable"))
    units.cells.push_back(csv_cell(equipment::unit_of_key(variable)));
  columns.push_back(std::move(units));
}

std::string csv_of(const std::vector<CsvColumn>& columns) {
  std::vector<std::string> names, units;
  for (const CsvColumn& column : columns) {
    names.push_back(csv_cell(column.name));
    units.push_back(csv_cell(column.units));
  }
  std::string all = csv_line(names) + csv_line(units);
  for (std::size_t row = 0; row < columns.front().cells.size(); ++row)
    for (std::size_t i = 0; i < columns.size(); ++i)
      all += columns[i].cells.at(row) + (i + 1 == columns.size() ? "\n" : ",");
  return all;
}

}  // namespace

void export_tables(const std::string& path, const TakeFile& take, const UnitSystem& chosen) {
  const UnitSystem units = chosen.or_else("si");
  const Hdf5Reader file(path);
  const std::vector<Table> tables = tables_of(file, path);
  for (Table table : tables) {
    std::ranges::stable_sort(table.datasets, {},
                             [&](const auto& each) { return order_of(table, each); });
    std::vector<CsvColumn> columns;
    for (const Hdf5Dataset& dataset : table.datasets)
      add_columns(file, table, dataset, units, columns);
    if (table.group == "drawn") add_units_of_drawn(file, columns);
    const bool alone =
        std::ranges::count(tables, table.group, [](const Table& t) { return t.group; }) == 1;
    take((alone ? table.group : table.group + "_" + table.scale) + ".csv", csv_of(columns));
  }
}

}  // namespace gurney::study
