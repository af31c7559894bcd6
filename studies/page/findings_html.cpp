#include "studies/page/findings_html.h"

#include <algorithm>

#include "studies/page/table.h"

namespace gurney::page {
namespace {

Cell cell_of(const findings::Cell& cell, const findings::Column& column) {
  const bool text = std::holds_alternative<std::string>(cell.value);
  Cell shown(cell.value.is_missing() && !text ? "\u2013"
                                              : written(cell.value, cell.format_in(column)));
  if (const auto* count = std::get_if<std::int64_t>(&cell.value))
    shown.number = static_cast<double>(*count);
  if (const auto* number = std::get_if<double>(&cell.value); number && !cell.value.is_missing())
    shown.number = *number;
  return shown;
}

std::string title_of(std::string label) {
  if (!label.empty() && label.find('_') == std::string::npos && label[0] >= 'a' && label[0] <= 'z')
    label[0] = static_cast<char>(label[0] - 'a' + 'A');
  return label;
}

Html of_table(const findings::Table& of) {
  Table table{title_of(of.title), {}};
  for (std::size_t i = 0; i < of.columns.size(); ++i) {
    const findings::Column& column = of.columns[i];
    if (column.label.empty()) continue;
    const std::string unit = column.format.unit;
    table.columns.push_back(
        {column.label + (unit.empty() ? "" : " (" + unit + ")"),
         std::ranges::none_of(
             of.rows,
             [&](const auto& row) { return std::holds_alternative<std::string>(row[i].value); }),
         column.meaning});
  }
  if (table.columns.empty()) return {};
  for (const auto& row : of.rows) {
    table.rows.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i)
      if (!of.columns[i].label.empty()) table.rows.back().push_back(cell_of(row[i], of.columns[i]));
  }
  return html(table);
}

}  // namespace

Html html(const findings::Table& table) {
  Html all;
  for (const findings::Table& each : groups_of(table)) all += of_table(each);
  return all;
}

Html html(const findings::Section& section) {
  Html all;
  std::vector<std::pair<std::string, std::string>> named;
  const auto flush = [&] {
    if (!named.empty()) all += facts(named);
    named.clear();
  };
  for (const findings::Part& part : section.parts) {
    if (const auto* fact = std::get_if<findings::Fact>(&part)) {
      if (!fact->label.empty() && !fact->value.is_missing())
        named.emplace_back(
            title_of(fact->label),
            with_unit(fact->value, fact->format) + (fact->note.empty() ? "" : ", " + fact->note));
      continue;
    }
    flush();
    if (const auto* table = std::get_if<findings::Table>(&part)) all += html(*table);
    if (const auto* sentence = std::get_if<findings::Sentence>(&part))
      all += paragraph(sentence->text);
    if (const auto* lines = std::get_if<findings::List>(&part);
        lines && !lines->title.empty() && !lines->lines.empty())
      all += element("h3", title_of(lines->title)) + list(lines->lines);
    if (const auto* inner = std::get_if<findings::Section>(&part)) {
      const Html content = html(*inner);
      if (!content.empty() && !inner->title.empty()) all += element("h3", title_of(inner->title));
      all += content;
    }
  }
  flush();
  return all;
}

}  // namespace gurney::page
