#pragma once

#include <string>

#include "studies/findings/findings.h"
#include "studies/units/unit_system.h"

namespace gurney::report {

/// A unit for people. JSON has SI, or what is chosen.
inline findings::Format format_of(const study::ReportUnit& unit, double json_unit,
                                  std::string digits = ".4g") {
  return {std::move(digits), unit.name == "1" ? "" : unit.name, unit.in_si, json_unit};
}
inline findings::Format format_of(const study::UnitSystem& units, const std::string& si,
                                  std::string digits = ".4g") {
  return format_of(units.of(si), units.or_else("si").of(si).in_si, std::move(digits));
}

/// Ends of an interval; nothing where there is none.
template <class Ends>
findings::Value ends(const Ends& of) {
  return findings::Numbers{of.low, of.high};
}

/// Columns for programs alone.
inline std::vector<findings::Column> json_columns(std::initializer_list<const char*> keys) {
  std::vector<findings::Column> columns;
  for (const char* const key : keys) columns.push_back({key, ""});
  return columns;
}

/// What a row has in a column; of a key alone: for programs alone.
struct Entry {
  Entry(findings::Column its_column, findings::Cell its_cell)
      : column(std::move(its_column)), cell(std::move(its_cell)) {}
  Entry(const char* key, findings::Cell its_cell) : Entry({key, ""}, std::move(its_cell)) {}

  findings::Column column;
  findings::Cell cell;
};

/// Adds a row to a table whose columns are those of the first.
inline void add_row(findings::Table& table, std::vector<Entry> row) {
  std::vector<findings::Cell> cells;
  for (Entry& each : row) {
    if (table.rows.empty()) table.columns.push_back(std::move(each.column));
    cells.push_back(std::move(each.cell));
  }
  table.add(std::move(cells));
}

/// "95 % interval" of a column of ends().
inline findings::Format interval_format(findings::Format of) {
  of.between = findings::kTo;
  of.unit.clear();
  return of;
}

}  // namespace gurney::report
