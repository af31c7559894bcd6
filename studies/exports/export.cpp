#include "studies/exports/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string_view>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/base/printable.h"
#include "engine/base/unit_table.h"
#include "equipment/catalogue/uncertainty.h"
#include "studies/analysis/demand_runs.h"
#include "studies/analysis/study_sensitivity.h"
#include "studies/results/columns.h"
#include "studies/results/hdf5_reader.h"

namespace gurney::study {
namespace {

/// A spreadsheet computes a cell that begins so; an apostrophe makes it text.
bool is_formula(const std::string& text) {
  return !text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos &&
         !number(text);
}

std::string quoted_where_needed(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

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

/// Identifiers of the row come first, then texts, then numbers.
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

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A number of every run of the file; NaN where there is none.
struct RunColumn {
  std::string name, units;
  std::vector<double> values;
};

/// Rows with the names of the columns, their units, and the runs.
std::string csv_of(const std::vector<RunColumn>& columns, const std::vector<std::size_t>& runs) {
  std::vector<std::string> names{""}, units{"Units"};
  for (const RunColumn& column : columns) {
    names.push_back(csv_cell(column.name));
    units.push_back(csv_cell(column.units));
  }
  std::string all = csv_line(names) + csv_line(units);
  for (const std::size_t run : runs) {
    std::vector<std::string> cells{std::to_string(run)};
    for (const RunColumn& column : columns) cells.push_back(csv_cell(column.values[run]));
    all += csv_line(cells);
  }
  return all;
}

/// The columns of a table with rows for items (and parts of them), as columns of runs.
template <class Row>
void add_demands(const StudyReader& file, const std::string& table, const std::string& part,
                 std::span<const TableColumn<Row>> wanted, const std::set<std::size_t>& runs,
                 std::vector<RunColumn>& columns) {
  const std::vector<std::string> items = file.strings(table + "/item");
  const std::vector<std::string> parts =
      part.empty() ? std::vector<std::string>(items.size()) : file.strings(table + "/" + part);
  const std::vector<double> run_of = file.numbers(table + "/run");
  std::vector<std::string> places;
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < items.size(); ++row) {
    if (!runs.contains(static_cast<std::size_t>(run_of[row]))) continue;
    const std::string place = items[row] + (part.empty() ? "" : "." + parts[row]);
    if (std::ranges::find(places, place) == places.end()) places.push_back(place);
    rows.push_back(row);
  }
  for (const TableColumn<Row>& each : wanted) {
    if (!file.has_column(table + "/" + each.name)) continue;
    const std::vector<double> values = file.numbers(table + "/" + each.name);
    std::map<std::string, std::vector<double>> of_place;
    for (const std::string& place : places) of_place[place].assign(file.runs(), kNaN);
    for (const std::size_t row : rows) {
      if (each.is_missing(values[row])) continue;
      const std::string place = items[row] + (part.empty() ? "" : "." + parts[row]);
      of_place[place][static_cast<std::size_t>(run_of[row])] = values[row];
    }
    for (const std::string& place : places)
      columns.push_back({place + "." + each.name, each.units, of_place[place]});
  }
}

void add_drawn(const StudyData& data, std::size_t configuration, std::vector<RunColumn>& columns) {
  if (!data.file().has("drawn")) return;
  const DrawnNumbers drawn = drawn_numbers({&data, configuration});
  for (const std::string& name : drawn.names) {
    RunColumn column{name, equipment::unit_of_key(name), {}};
    const auto& of_draw = drawn.values.at(name);
    for (const double draw : data.file().numbers("runs/draw")) {
      const auto found = draw < 0 ? of_draw.end() : of_draw.find(static_cast<std::size_t>(draw));
      column.values.push_back(found == of_draw.end() ? kNaN : found->second);
    }
    columns.push_back(std::move(column));
  }
}

RunColumn errors_of(const StudyReader& file) {
  RunColumn column{"ERROR", "", std::vector<double>(file.runs(), 0)};
  for (const double run : file.numbers("failures/run")) column.values.at(std::size_t(run)) = 1;
  return column;
}

/// Demands without those of failed runs, which the file has none of: a failed run may be cut.
void clear_failed(const RunColumn& errors, std::vector<RunColumn>& columns) {
  for (RunColumn& column : columns)
    for (std::size_t run = 0; run < errors.values.size(); ++run)
      if (errors.values[run] != 0) column.values[run] = kNaN;
}

/// Adds the measures that any record has.
void add_measures(const StudyData& data, std::vector<RunColumn>& columns) {
  for (const std::string& name : data.measures()) try {
      const RunMeasure measure = data.measure(name);
      columns.push_back({measure.name, measure.units, measure.values});
    } catch (const Error&) {  // no record has it
    }
}

std::vector<RunColumn> responses(const StudyData& data, std::size_t configuration,
                                 const std::set<std::size_t>& runs) {
  const StudyReader& file = data.file();
  std::vector<RunColumn> columns;
  add_drawn(data, configuration, columns);
  columns.push_back({"angle", "rad", file.numbers("runs/angle")});
  columns.push_back({"scale", "1", file.numbers("runs/scale")});
  add_measures(data, columns);
  std::vector<RunColumn> demands;
  add_demands(file, "items", "", demand_columns(), runs, demands);
  add_demands(file, "points", "point", point_demand_columns(), runs, demands);
  const RunColumn errors = errors_of(file);
  clear_failed(errors, demands);
  append_all(columns, demands);
  columns.push_back(errors);
  return columns;
}

/// pelicun's word for a unit; empty: it has none.
std::string pelicun_unit(const std::string& units) {
  const SiUnit* const unit = si_unit(units);
  return unit == nullptr ? "" : unit->pelicun;
}

/// The columns of responses() that pelicun can load, with its names and units.
std::vector<RunColumn> pelicun_demands(const StudyData& data, const std::set<std::size_t>& runs) {
  const StudyReader& file = data.file();
  std::vector<RunColumn> columns{{"PFA-0-1", "mps2", file.numbers("runs/pfa")},
                                 {"PFV-0-1", "mps", file.numbers("runs/pfv")}};
  for (const TableColumn<Demands>& each : demand_columns()) {
    if (each.missing != 0 || pelicun_unit(each.units).empty()) continue;
    std::vector<RunColumn> of_items;
    add_demands(file, "items", "", std::span(&each, 1), runs, of_items);
    for (RunColumn& column : of_items) {
      const std::string item = column.name.substr(0, column.name.rfind('.'));
      const std::string name = fmt::format("{}-{}-1", each.name, plain_identifier(item, "item"));
      require(std::ranges::find(columns, name, &RunColumn::name) == columns.end(),
              fmt::format("{}: two items would have the column {}; their names must differ in more "
                          "than signs and spaces",
                          file.path(), name));
      columns.push_back({name, pelicun_unit(each.units), column.values});
    }
  }
  const RunColumn errors = errors_of(file);
  clear_failed(errors, columns);
  columns.push_back(errors);
  return columns;
}

}  // namespace

std::string plain_identifier(const std::string& text, const std::string& otherwise) {
  std::string plain;
  bool any = false;
  for (const char c : text) {
    const bool keep = std::isalnum(static_cast<unsigned char>(c)) != 0;
    any = any || keep;
    if (keep || plain.empty() || plain.back() != '_') plain += keep ? c : '_';
  }
  return any ? plain : otherwise;
}

std::string csv_cell(const std::string& text) {
  const std::string plain = printable(text);
  return quoted_where_needed(is_formula(plain) ? "'" + plain : plain);
}

std::string csv_cell(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

std::string csv_line(const std::vector<std::string>& cells) {
  return fmt::format("{}\n", fmt::join(cells, ","));
}

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

void export_responses(const StudyData& data, const ExportChoice& choice, const TakeFile& take) {
  const RunLevels levels = run_levels(data);
  const std::vector<double> of = data.file().numbers("runs/configuration");
  std::set<std::string> taken;
  const auto take_once = [&](const std::string& name, const std::string& bytes) {
    require(taken.insert(name).second,
            fmt::format("{}: two configurations would be written to {}; choose one with "
                        "--configuration",
                        data.file().path(), name));
    take(name, bytes);
  };
  for (const std::size_t configuration : wanted_configurations(data, choice.configurations)) {
    const std::string& name = data.configurations()[configuration];
    const std::string tail = name.empty() ? "" : "_" + plain_identifier(name, "variant");
    std::vector<std::size_t> runs;
    for (std::size_t run = 0; run < of.size(); ++run)
      if (static_cast<std::size_t>(of[run]) == configuration) runs.push_back(run);
    const std::set<std::size_t> all(runs.begin(), runs.end());
    take_once("response" + tail + ".csv", csv_of(responses(data, configuration, all), runs));
    if (levels.traced) continue;
    const std::vector<RunColumn> demands = pelicun_demands(data, all);
    for (std::size_t level = 0; level < levels.texts.size(); ++level) {
      std::vector<std::size_t> at_level;
      for (const std::size_t run : runs)
        if (levels.of_run[run] == level) at_level.push_back(run);
      if (at_level.empty()) continue;  // of another configuration's stages
      take_once("demands" + tail + "_" + plain_identifier(levels.texts[level], "level") + ".csv",
                csv_of(demands, at_level));
    }
  }
}

}  // namespace gurney::study
