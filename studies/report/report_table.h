#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gurney::report {

/// A column of a report: what people read and what programs read comes from the same cell.
struct ReportColumn {
  std::string title;    ///< in text and Markdown; empty: of JSON alone
  std::string align{};  ///< in text: `<24`, `>7`
  std::string form{};   ///< of a number in text and Markdown: `.1f`
  std::string key{};    ///< in JSON; empty: of text alone
  double factor = 1;    ///< from SI to the unit of the title
};

class ReportTable {
 public:
  using Cell = std::variant<std::string, double, std::size_t>;

  explicit ReportTable(std::vector<ReportColumn> columns) : columns_(std::move(columns)) {}

  /// @param cells  one for each column, numbers in SI units
  void add(std::vector<Cell> cells) { rows_.push_back(std::move(cells)); }

  std::string text() const;             ///< titles and rows, a line each
  std::string markdown() const;         ///< `|` in a text is escaped
  nlohmann::ordered_json json() const;  ///< an array of objects

 private:
  std::vector<ReportColumn> columns_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace gurney::report
