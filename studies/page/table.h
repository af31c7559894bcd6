#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/report_unit.h"
#include "studies/page/html.h"

namespace gurney::page {

/// What a table shows in a cell, and by what it is sorted.
struct Cell {
  std::string text;
  std::optional<double> number = {};  ///< as the file has it [SI]; none: sorted by the text

  Cell(std::string of) : text(std::move(of)) {}  // NOLINT: cells are written as lists
  Cell(const char* of) : text(of) {}             // NOLINT
  Cell(std::size_t count);                       // NOLINT
  /// Shown with `digits` significant ones in a unit; not a number: as a dash.
  Cell(double value, const study::ReportUnit& unit, int digits = 3);
};

struct Column {
  std::string title;         ///< with its unit
  bool numbers = false;      ///< to the right
  std::string meaning = {};  ///< shown when one points at the title
};

/// A table whose rows are sorted by a click on a title; its first column names the rows.
struct Table {
  std::string caption;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows = {};
};

/// Empty without rows.
Html html(const Table& table);

}  // namespace gurney::page
