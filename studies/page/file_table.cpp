#include "studies/page/file_table.h"

#include <algorithm>

#include "studies/figures/labels.h"

namespace gurney::page {
namespace {

using findings::Cell;
using findings::Table;
using findings::Value;

struct GroupColumn {
  std::string name;
  findings::Column head;
  std::vector<Value> values;
  bool text = false;
};

/// Values that mean "none": of times -1, of numbers NaN.
Value value_of(const study::Hdf5Dataset& dataset, double value) {
  if (dataset.units == "s" && value == -1) return {};
  return dataset.type == "int64" ? Value(static_cast<std::int64_t>(value)) : Value(value);
}

std::vector<GroupColumn> columns_of(const study::Hdf5Reader& file, const std::string& group,
                                    const study::UnitSystem& units,
                                    const std::vector<std::string>& first) {
  std::vector<GroupColumn> columns;
  const std::string before = "/" + group + "/";
  for (const study::Hdf5Dataset& dataset : file.datasets()) {
    if (!dataset.path.starts_with(before) || dataset.shape.size() != 1) continue;
    const std::string name = dataset.path.substr(before.size());
    if (name == "row" || name == "run") continue;
    const bool text = dataset.type == "string";
    const study::ReportUnit unit = units.of(text ? "1" : dataset.units);
    GroupColumn column{name,
                       {"",
                        figures::with_unit(figures::label_of(name), unit),
                        {".4g", "", unit.in_si},
                        dataset.long_name},
                       {},
                       text};
    if (text)
      for (const std::string& each : file.strings(dataset.path)) column.values.emplace_back(each);
    else
      for (const double each : file.numbers(dataset.path))
        column.values.push_back(value_of(dataset, each));
    columns.push_back(std::move(column));
  }
  std::ranges::stable_sort(columns, {}, [&](const GroupColumn& column) {
    return std::ranges::find(first, column.name) - first.begin();
  });
  return columns;
}

}  // namespace

Table table_of_group(const study::Hdf5Reader& file, const std::string& group,
                     const std::string& caption, const std::vector<std::string>& first,
                     const study::UnitSystem& units) {
  const std::vector<GroupColumn> columns = columns_of(file, group, units, first);
  Table table{"", caption, {}};
  for (const GroupColumn& column : columns) {
    table.columns.push_back(column.head);
    table.rows.resize(column.values.size());
    for (std::size_t row = 0; row < column.values.size(); ++row)
      table.rows[row].emplace_back(column.values[row]);
  }
  // Columns as long as the shortest.
  std::erase_if(table.rows, [&](const auto& row) { return row.size() != columns.size(); });
  return table;
}

Table turned_table_of_group(const study::Hdf5Reader& file, const std::string& group,
                            const std::string& caption, const std::string& name,
                            const study::UnitSystem& units, const std::vector<std::string>& first) {
  const std::vector<GroupColumn> columns = columns_of(file, group, units, first);
  Table table{"", caption, {{"", "Quantity"}}};
  for (const GroupColumn& column : columns)
    if (column.name == name)
      for (const Value& each : column.values) table.columns.push_back({"", written(each, {})});
  if (name.empty()) table.columns.push_back({"", "Value"});
  table.columns.push_back({"", "Meaning"});
  for (const GroupColumn& column : columns) {
    if (column.text || column.values.size() + 2 != table.columns.size() ||
        std::ranges::all_of(column.values, &Value::is_missing))
      continue;
    std::vector<Cell> row{column.head.label};
    for (const Value& each : column.values) row.emplace_back(each, column.head.format);
    row.emplace_back(column.head.meaning);
    table.add(std::move(row));
  }
  return table;
}

}  // namespace gurney::page
