#include "studies/page/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gurney::page {
namespace {

Html head_of(const Table& table) {
  Html row;
  for (const Column& column : table.columns) {
    Attributes attributes{{"scope", "col"}, {"aria-sort", "none"}};
    if (column.numbers) attributes.emplace_back("class", "number");
    if (!column.meaning.empty()) attributes.emplace_back("title", column.meaning);
    row += element("th", element("button", column.title, {{"type", "button"}}), attributes);
  }
  return element("thead", element("tr", row));
}

/// How the width of a cell is found: that of a number, of a sentence, or of a word that is longer
/// than a column should be.
std::string class_of(const Cell& cell, const Column& column) {
  constexpr std::size_t kLongWord = 30, kSentence = 40, kShort = 24;
  if (column.numbers) return "number";
  std::size_t longest = 0, word = 0;
  for (const char c : cell.text) longest = std::max(longest, word = c == ' ' ? 0 : word + 1);
  if (longest > kLongWord) return "long";
  return cell.text.size() > kSentence ? "prose" : cell.text.size() < kShort ? "short" : "";
}

Html html(const Cell& cell, const Column& column, bool names_row) {
  Attributes attributes;
  if (names_row) attributes.emplace_back("scope", "row");
  if (const std::string of = class_of(cell, column); !of.empty())
    attributes.emplace_back("class", of);
  if (cell.number) attributes.emplace_back("data-value", fmt::format("{}", *cell.number));
  return element(names_row ? "th" : "td", cell.text, attributes);
}

}  // namespace

Cell::Cell(std::size_t count) : text(std::to_string(count)), number(static_cast<double>(count)) {}

Cell::Cell(double value, const study::ReportUnit& unit, int digits)
    : text(std::isnan(value) ? "\u2013" : fmt::format("{:.{}g}", value / unit.in_si, digits)),
      number(value) {
  if (!std::isfinite(value)) number.reset();
}

Html html(const Table& table) {
  if (table.rows.empty()) return {};
  Html body;
  for (const std::vector<Cell>& row : table.rows) {
    Html cells;
    for (std::size_t i = 0; i < row.size(); ++i) cells += html(row[i], table.columns[i], i == 0);
    body += element("tr", cells);
  }
  constexpr std::size_t kLong = 40;  // rows; shorter tables are shown whole
  return element(
      "div",
      element("table", element("caption", table.caption) + head_of(table) + element("tbody", body)),
      {{"class", table.rows.size() > kLong ? "scroll tall" : "scroll"},
       {"tabindex", "0"},
       {"role", "region"},
       {"aria-label", table.caption}});
}

}  // namespace gurney::page
