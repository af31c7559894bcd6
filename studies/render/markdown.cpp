#include "studies/render/render.h"

namespace gurney::render {
namespace {

/// `|` would end a cell.
std::string escaped(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, "\\");
  return text;
}

}  // namespace

std::string markdown(const findings::Table& table) {
  if (table.rows.empty()) return {};
  std::string titles = "|", rule = "|", rows;
  for (const findings::Column& column : table.columns)
    if (!column.label.empty()) {
      titles += " " + heading(column) + " |";
      rule += " --- |";
    }
  for (const auto& row : table.rows) {
    rows += "|";
    for (std::size_t i = 0; i < row.size(); ++i)
      if (!table.columns[i].label.empty())
        rows += " " + escaped(written(row[i].value, row[i].format_in(table.columns[i]))) + " |";
    rows += "\n";
  }
  return titles + "\n" + rule + "\n" + rows;
}

}  // namespace gurney::render
