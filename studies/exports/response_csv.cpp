#include "studies/exports/response_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "engine/base/error.h"
#include "equipment/catalogue/uncertainty.h"
#include "studies/analysis/run_levels.h"
#include "studies/results/columns.h"

namespace gurney::study {
namespace {

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

void add_drawn(const StudyReader& file, std::size_t configuration,
               std::vector<RunColumn>& columns) {
  if (!file.has("drawn")) return;
  const std::vector<double> of = file.numbers("drawn/configuration"),
                            draws = file.numbers("drawn/draw"),
                            values = file.numbers("drawn/value"),
                            draw_of_run = file.numbers("runs/draw");
  const std::vector<std::string> variables = file.strings("drawn/variable");
  std::vector<std::string> names;
  std::map<std::string, std::map<double, double>> by_draw;
  for (std::size_t row = 0; row < of.size(); ++row) {
    if (static_cast<std::size_t>(of[row]) != configuration) continue;
    if (!by_draw.contains(variables[row])) names.push_back(variables[row]);
    by_draw[variables[row]][draws[row]] = values[row];
  }
  for (const std::string& name : names) {
    RunColumn column{name, equipment::unit_of_key(name), {}};
    for (const double draw : draw_of_run) {
      const auto found = by_draw[name].find(draw);
      column.values.push_back(found == by_draw[name].end() ? kNaN : found->second);
    }
    columns.push_back(column);
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

/// Those that any record has.
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
  add_drawn(file, configuration, columns);
  columns.push_back({"angle", "rad", file.numbers("runs/angle")});
  columns.push_back({"scale", "1", file.numbers("runs/scale")});
  add_measures(data, columns);
  std::vector<RunColumn> demands;
  add_demands(file, "items", "", demand_columns(), runs, demands);
  add_demands(file, "points", "point", point_demand_columns(), runs, demands);
  const RunColumn errors = errors_of(file);
  clear_failed(errors, demands);
  columns.insert(columns.end(), demands.begin(), demands.end());
  columns.push_back(errors);
  return columns;
}

/// pelicun's word for a unit; empty: it has none.
std::string pelicun_unit(const std::string& units) {
  static const std::map<std::string, std::string> kUnits = {
      {"m", "m"},   {"m/s", "mps"}, {"m/s2", "mps2"}, {"rad", "rad"},
      {"s", "sec"}, {"N", "N"},     {"1", "unitless"}};
  const auto found = kUnits.find(units);
  return found == kUnits.end() ? "" : found->second;
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
      columns.push_back({fmt::format("{}-{}-1", each.name, plain_identifier(item, "item")),
                         pelicun_unit(each.units), column.values});
    }
  }
  const RunColumn errors = errors_of(file);
  clear_failed(errors, columns);
  columns.push_back(errors);
  return columns;
}

}  // namespace

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
  for (const std::size_t configuration : chosen_configurations(data, choice)) {
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
      take_once("demands" + tail + "_" + plain_identifier(levels.texts[level], "level") + ".csv",
                csv_of(demands, at_level));
    }
  }
}

}  // namespace gurney::study
