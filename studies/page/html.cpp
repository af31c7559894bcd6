#include "studies/page/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include "embedded/chart_js.h"
#include "embedded/page_css.h"
#include "embedded/page_html.h"
#include "embedded/page_js.h"
#include "engine/base/printable.h"

namespace gurney::page {
namespace {

/// Blanks between elements inside a line would show.
bool ends_line(std::string_view tag) {
  for (const std::string_view block : {"tr", "p", "li", "ul", "dd", "dl", "h3", "div", "figure",
                                       "section", "details", "table", "caption", "script"})
    if (tag == block) return true;
  return false;
}

void replace_all(std::string& text, std::string_view from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

/// Ids of the figure, which are those of its clip paths, become unique on the page. Texts between
/// the tags stay as they are.
std::string with_own_ids(const std::string& svg, const std::string& name) {
  std::string result;
  std::size_t at = 0;
  while (at < svg.size()) {
    const std::size_t open = svg.find('<', at);
    const std::size_t close = open == std::string::npos ? open : svg.find('>', open);
    result += svg.substr(at, open == std::string::npos ? open : open - at);
    if (close == std::string::npos) break;
    std::string tag = svg.substr(open, close + 1 - open);
    replace_all(tag, "id=\"clip", "id=\"" + name + "-clip");
    replace_all(tag, "url(#clip", "url(#" + name + "-clip");
    result += tag;
    at = close + 1;
  }
  return result;
}

/// The text of the element of this name, and the picture without it.
std::string take(std::string& svg, const std::string& tag) {
  const std::string open = "<" + tag + ">", close = "</" + tag + ">\n";
  const std::size_t at = svg.find(open), end = svg.find(close);
  if (at == std::string::npos || end == std::string::npos) return {};
  const std::string text = svg.substr(at + open.size(), end - at - open.size());
  svg.erase(at, end + close.size() - at);
  return text;
}

/// One picture. Its own description, such as what its lines and areas are, ends the caption.
Html figure(const Drawing& drawing, std::string svg, const std::string& name,
            const std::string& caption) {
  const std::string title = name + "-title", about = name + "-about";
  const std::string note = take(svg, "desc");
  svg = with_own_ids(svg, name);
  const std::size_t end = svg.find('>');
  const Html names = element("title", drawing.caption, {{"id", title}}) +
                     element("desc", drawing.description, {{"id", about}});
  svg.insert(end + 1, "\n" + names.code);
  svg.insert(4,
             " role=\"img\" aria-labelledby=\"" + title + "\" aria-describedby=\"" + about + "\"");
  const Html link =
      element("a", "Save as SVG",
              {{"class", "save"}, {"href", "#" + name + "-figure"}, {"download", name + ".svg"}});
  Html words = escaped(caption.empty() ? "" : caption + " ");
  if (!note.empty() && !caption.empty()) words += Html{"Key: " + note + ". "};
  return element(
      "figure",
      element("div", Html{svg}, {{"class", "paper"}}) + element("figcaption", words + link),
      {{"id", name + "-figure"}});
}

/// The browser loads the page again, and keeps its place.
constexpr const char* kAgain = "<meta http-equiv=\"refresh\" content=\"3\">\n";

/// The text with each `{{name}}` of it replaced; what is put in is not looked at again.
std::string filled(std::string_view text,
                   const std::map<std::string_view, std::string_view>& with) {
  std::string result;
  while (true) {
    const std::size_t open = text.find("{{"), close = text.find("}}", open);
    if (close == std::string_view::npos) return result.append(text);
    result.append(text.substr(0, open));
    result.append(with.at(text.substr(open + 2, close - open - 2)));
    text.remove_prefix(close + 2);
  }
}

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

Html escaped(std::string_view text) { return {xml_text(text)}; }

Html element(const std::string& tag, const Html& content, const Attributes& attributes) {
  std::string open = "<" + tag;
  for (const auto& [name, value] : attributes)
    open += " " + name + "=\"" + escaped(value).code + "\"";
  return {open + ">" + content.code + "</" + tag + (ends_line(tag) ? ">\n" : ">")};
}

Html element(const std::string& tag, std::string_view text, const Attributes& attributes) {
  return element(tag, escaped(text), attributes);
}

Html paragraph(std::string_view text) { return element("p", text); }

Html list(const std::vector<std::string>& texts) {
  Html items;
  for (const std::string& text : texts) items += element("li", text);
  return items.empty() ? items : element("ul", items);
}

Html facts(const std::vector<std::pair<std::string, std::string>>& named) {
  Html items;
  for (const auto& [name, value] : named) items += element("dt", name) + element("dd", value);
  return items.empty() ? items : element("dl", items);
}

Html folded(std::string_view summary, const Html& content) {
  return element("details", element("summary", summary) + content);
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

Html html(const Drawing& drawing) {
  const std::string end = "</svg>\n";
  Html all;
  std::size_t from = 0;
  for (std::size_t count = 1, to; from < drawing.svg.size(); from = to, ++count) {
    const std::size_t at = drawing.svg.find(end, from);
    to = at == std::string::npos ? drawing.svg.size() : at + end.size();
    all += figure(drawing, drawing.svg.substr(from, to - from),
                  count == 1 ? drawing.name : drawing.name + "-" + std::to_string(count),
                  count == 1 ? drawing.caption : "");
  }
  return all;
}

Html side_by_side(const Html& figures) {
  return figures.empty() ? figures : element("div", figures, {{"class", "figures"}});
}

std::string html(const Document& document) {
  Html contents, body;
  for (const Section& section : document.sections) {
    if (section.content.empty()) continue;
    const std::string heading = section.id + "-heading";
    contents += element("li", element("a", section.title, {{"href", "#" + section.id}}));
    body += element("section", element("h2", section.title, {{"id", heading}}) + section.content,
                    {{"id", section.id}, {"aria-labelledby", heading}});
  }
  const std::string title = escaped(document.title).code,
                    subtitle = escaped(document.subtitle).code,
                    program = escaped(document.program).code;
  return filled(embedded::page_html, {{"title", title},
                                      {"again", document.again ? kAgain : ""},
                                      {"subtitle", subtitle},
                                      {"program", program},
                                      {"style", embedded::page_css},
                                      {"script", embedded::page_js},
                                      {"charts", embedded::chart_js},
                                      {"contents", contents.code},
                                      {"sections", body.code}});
}

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
