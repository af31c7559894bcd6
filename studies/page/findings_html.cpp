#include "studies/page/findings_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gurney::page {
namespace {

using findings::Cell;
using findings::Column;
using findings::Table;

std::string title_of(std::string label) {
  if (!label.empty() && label.find('_') == std::string::npos && label[0] >= 'a' && label[0] <= 'z')
    label[0] = static_cast<char>(label[0] - 'a' + 'A');
  return label;
}

/// By which a cell is sorted; none: by its text.
std::optional<double> number_of(const Cell& cell) {
  if (const auto* count = std::get_if<std::int64_t>(&cell.value))
    return static_cast<double>(*count);
  const auto* const ends = std::get_if<findings::Numbers>(&cell.value);
  const auto* const number = std::get_if<double>(&cell.value);
  const double value = number != nullptr                  ? *number
                       : ends == nullptr || ends->empty() ? std::nan("")
                                                          : ends->back();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool is_number(const Table& table, std::size_t column) {
  return std::ranges::none_of(table.rows, [&](const auto& row) {
    const findings::Value& value = row[column].value;
    return std::holds_alternative<std::string>(value) ||
           std::holds_alternative<findings::Texts>(value);
  });
}

std::string text_of(const Cell& cell, const Column& column) {
  const bool text = std::holds_alternative<std::string>(cell.value);
  return cell.value.is_missing() && !text ? "\u2013" : written(cell.value, cell.format_in(column));
}

/// A SHA-256 by its first digits, in grey; all of it where one points.
Html shortened(const std::string& text) {
  constexpr std::size_t kHash = 64, kShown = 12;
  return text.size() == kHash && text.find_first_not_of("0123456789abcdef") == text.npos
             ? element("span", text.substr(0, kShown), {{"class", "hash"}, {"title", text}})
             : escaped(text);
}

/// How the width of a cell is found: that of a number, of a sentence, or of a word that is longer
/// than a column should be.
std::string class_of(const std::string& text) {
  constexpr std::size_t kLongWord = 30, kSentence = 40, kShort = 24;
  std::size_t longest = 0, word = 0;
  for (const char c : text) longest = std::max(longest, word = c == ' ' ? 0 : word + 1);
  if (longest > kLongWord) return "long";
  return text.size() > kSentence ? "prose" : text.size() < kShort ? "short" : "";
}

Html html_of(const Cell& cell, const Column& column, bool number, bool names_row) {
  const std::string text = text_of(cell, column), of = number ? "number" : class_of(text);
  Attributes attributes;
  if (names_row) attributes.emplace_back("scope", "row");
  if (!of.empty()) attributes.emplace_back("class", of);
  if (const auto value = number_of(cell))
    attributes.emplace_back("data-value", fmt::format("{}", *value));
  return element(names_row ? "th" : "td", shortened(text), attributes);
}

Html html_of(const Table& table) {
  std::vector<std::size_t> shown;
  std::vector<bool> numbers;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (!table.columns[i].label.empty()) shown.push_back(i);
    numbers.push_back(is_number(table, i));
  }
  if (shown.empty() || table.rows.empty()) return {};
  Html head, body;
  for (const std::size_t i : shown) {
    const Column& column = table.columns[i];
    Attributes attributes{{"scope", "col"}, {"aria-sort", "none"}};
    if (numbers[i]) attributes.emplace_back("class", "number");
    if (!column.meaning.empty()) attributes.emplace_back("title", column.meaning);
    const std::string unit = column.format.unit.empty() ? "" : " (" + column.format.unit + ")";
    head += element("th", element("button", column.label + unit, {{"type", "button"}}), attributes);
  }
  for (const auto& row : table.rows) {
    Html cells;
    for (const std::size_t i : shown)
      cells += html_of(row[i], table.columns[i], numbers[i], i == shown.front());
    body += element("tr", cells);
  }
  constexpr std::size_t kLong = 40;  // rows; shorter tables are shown whole
  const std::string title = title_of(table.title);
  return element(
      "div",
      element("table", element("caption", title) + element("thead", element("tr", head)) +
                           element("tbody", body)),
      {{"class", table.rows.size() > kLong ? "scroll tall" : "scroll"},
       {"tabindex", "0"},
       {"role", "region"},
       {"aria-label", title}});
}

}  // namespace

Html html(const Table& table) {
  Html all;
  for (const Table& each : groups_of(table)) all += html_of(each);
  return all;
}

Html caution_box(const findings::Texts& cautions) {
  constexpr std::size_t kShown = 8;
  if (cautions.empty()) return {};
  const auto end =
      cautions.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, cautions.size()));
  Html box = element("h3", findings::kCautions) + list({cautions.begin(), end});
  if (end != cautions.end())
    box += folded(fmt::format("{} more", cautions.end() - end), list({end, cautions.end()}));
  return element("div", box, {{"class", "cautions"}});
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
    if (const auto* table = std::get_if<Table>(&part)) all += html(*table);
    if (const auto* sentence = std::get_if<findings::Sentence>(&part))
      all += paragraph(sentence->text);
    if (const auto* lines = std::get_if<findings::List>(&part);
        lines && !lines->title.empty() && !lines->lines.empty())
      all += lines->title == findings::kCautions
                 ? caution_box(lines->lines)
                 : element("h3", title_of(lines->title)) + list(lines->lines);
    if (const auto* inner = std::get_if<findings::Section>(&part)) {
      const Html content = html(*inner);
      if (!content.empty() && !inner->title.empty()) all += element("h3", title_of(inner->title));
      all += content;
    }
  }
  flush();
  return all;
}

std::vector<Section> sections_of(const findings::Section& findings, const findings::Texts& ids) {
  std::vector<Section> all;
  for (const findings::Part& part : findings.parts)
    if (const auto* inner = std::get_if<findings::Section>(&part); inner && !inner->title.empty())
      all.push_back({ids.at(all.size()), inner->title, html(*inner)});
  return all;
}

}  // namespace gurney::page
