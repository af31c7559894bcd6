#include "studies/page/file_table.h"

#include <algorithm>

#include "studies/figures/labels.h"

namespace gurney::page {
namespace {

struct GroupColumn {
  std::string name;
  Column head;
  std::vector<Cell> cells;
};

/// Values that mean "none": of times -1, of numbers NaN.
Cell cell_of(const study::Hdf5Dataset& dataset, double value, const study::UnitSystem& units) {
  if (dataset.units == "s" && value == -1) return {"\u2013"};
  if (dataset.type == "int64") {
    Cell cell(std::to_string(static_cast<long>(value)));
    cell.number = value;
    return cell;
  }
  return Cell(value, units.of(dataset.units), 4);
}

std::vector<GroupColumn> columns_of(const study::Hdf5Reader& file, const std::string& group,
                                    const study::UnitSystem& units) {
  std::vector<GroupColumn> columns;
  const std::string before = "/" + group + "/";
  for (const study::Hdf5Dataset& dataset : file.datasets()) {
    if (!dataset.path.starts_with(before) || dataset.shape.size() != 1) continue;
    const std::string name = dataset.path.substr(before.size());
    if (name == "row" || name == "run") continue;
    const bool text = dataset.type == "string";
    GroupColumn column{name,
                       {text ? figures::label_of(name)
                             : figures::with_unit(figures::label_of(name), units.of(dataset.units)),
                        !text, dataset.long_name},
                       {}};
    if (text)
      for (const std::string& each : file.strings(dataset.path)) column.cells.emplace_back(each);
    else
      for (const double each : file.numbers(dataset.path))
        column.cells.push_back(cell_of(dataset, each, units));
    columns.push_back(std::move(column));
  }
  return columns;
}

void put_first(std::vector<GroupColumn>& columns, const std::vector<std::string>& first) {
  std::ranges::stable_sort(columns, {}, [&](const GroupColumn& column) {
    return std::ranges::find(first, column.name) - first.begin();
  });
}

}  // namespace

Table table_of_group(const study::Hdf5Reader& file, const std::string& group,
                     const std::string& caption, const std::vector<std::string>& first,
                     const study::UnitSystem& units) {
  std::vector<GroupColumn> columns = columns_of(file, group, units);
  put_first(columns, first);
  Table table{caption, {}};
  for (const GroupColumn& column : columns) table.columns.push_back(column.head);
  std::size_t rows = columns.empty() ? 0 : columns.front().cells.size();
  for (const GroupColumn& column : columns) rows = std::min(rows, column.cells.size());
  for (std::size_t row = 0; row < rows; ++row) {
    table.rows.emplace_back();
    for (const GroupColumn& column : columns) table.rows.back().push_back(column.cells[row]);
  }
  return table;
}

Table turned_table_of_group(const study::Hdf5Reader& file, const std::string& group,
                            const std::string& caption, const std::string& name,
                            const study::UnitSystem& units, const std::vector<std::string>& first) {
  std::vector<GroupColumn> columns = columns_of(file, group, units);
  put_first(columns, first);
  Table table{caption, {{"Quantity"}}};
  for (const GroupColumn& column : columns)
    if (column.name == name)
      for (const Cell& cell : column.cells) table.columns.push_back({cell.text, true});
  if (name.empty()) table.columns.push_back({"Value", true});
  table.columns.push_back({"Meaning"});
  for (const GroupColumn& column : columns) {
    if (!column.head.numbers || column.cells.size() + 2 != table.columns.size()) continue;
    if (std::ranges::none_of(column.cells,
                             [](const Cell& cell) { return cell.number.has_value(); }))
      continue;
    std::vector<Cell> row{column.head.title};
    row.insert(row.end(), column.cells.begin(), column.cells.end());
    row.emplace_back(column.head.meaning);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace gurney::page
