#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "engine/base/append_all.h"
#include "engine/base/printable.h"
#include "studies/render/render.h"
#include "studies/render/wrapped.h"

namespace gurney::render {
namespace {

using namespace findings;

/// Characters of a text in UTF-8.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](unsigned char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string blanks(width - std::min(width, width_of(text)), ' ');
  return right ? blanks + text : text + blanks;
}

std::string title_text(const std::string& text) { return bold(printable(text)); }

bool is_shown(const Fact& fact) { return !fact.label.empty() && !fact.value.is_missing(); }

std::string value_text(const Fact& fact) {
  return printable(with_unit(fact.value, fact.format) +
                   (fact.note.empty() ? "" : ", " + fact.note));
}

std::string more(std::size_t count, const std::string& indent) {
  return count == 0 ? "" : fmt::format("{}and {} more; --json lists all\n", indent, count);
}

/// A column of texts, its heading first.
struct Cells {
  Texts cells;
  bool right = true;
  std::size_t most = std::string::npos;  ///< wide; longer texts are broken

  std::size_t width() const {
    return std::min(most, width_of(*std::ranges::max_element(cells, {}, width_of)));
  }
};

/// Words in lines as wide as that, or as their longest word.
Texts lines_of(const std::string& text, std::size_t width) {
  if (width_of(text) <= width) return {text};
  Texts lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.empty() && width_of(lines.back()) + 1 + width_of(word) <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

std::size_t width_of(const std::vector<Cells>& columns) {
  std::size_t width = 0;
  for (const Cells& of : columns) width += of.width() + 2;
  return width - 2;
}

/// Breaks the widest texts until the columns fit, or all are narrow.
void narrow(std::vector<Cells>& columns, std::size_t most) {
  constexpr std::size_t kLeast = 22;
  for (std::size_t i = 0; i < columns.size() && width_of(columns) > most; ++i) {
    Cells& widest = *std::ranges::max_element(
        columns, {}, [](const Cells& of) { return of.right ? 0 : of.width(); });
    const std::size_t over = width_of(columns) - most, width = widest.width();
    if (widest.right || width <= kLeast) return;
    widest.most = std::max(kLeast, width - std::min(width, over));
    std::size_t longest = 0;  // a word is not broken
    for (const std::string& cell : widest.cells)
      for (const std::string& line : lines_of(cell, widest.most))
        longest = std::max(longest, width_of(line));
    widest.most = longest;
  }
}

/// Columns that stand beside each other, each time with the first of all.
std::vector<std::vector<Cells>> blocks_of(const std::vector<Cells>& columns, std::size_t most) {
  std::vector<std::vector<Cells>> blocks{{columns.front()}};
  for (std::size_t i = 1; i < columns.size(); ++i) {
    std::vector<Cells> with = blocks.back();
    with.push_back(columns[i]);
    if (blocks.back().size() > 1 && width_of(with) > most)
      blocks.push_back({columns.front(), columns[i]});
    else
      blocks.back() = std::move(with);
  }
  return blocks;
}

std::string block_text(const std::vector<Cells>& columns, std::size_t headings,
                       const std::string& indent) {
  std::string all;
  for (std::size_t row = 0; row < columns.front().cells.size(); ++row) {
    std::vector<Texts> cells;
    std::size_t high = 1;
    for (const Cells& of : columns) {
      cells.push_back(lines_of(of.cells[row], of.width()));
      high = std::max(high, cells.back().size());
    }
    for (std::size_t at = 0; at < high; ++at) {
      std::string line = indent;
      for (std::size_t i = 0; i < columns.size(); ++i)
        line += (i == 0 ? "" : "  ") + padded(at < cells[i].size() ? cells[i][at] : "",
                                              columns[i].width(), columns[i].right);
      line.erase(line.find_last_not_of(' ') + 1);
      all += (row < headings ? bold(line) : line) + "\n";
    }
  }
  return all;
}

/// @param units_below  in a line of their own
std::vector<Cells> cells_of(const Table& table, std::size_t rows, bool units_below) {
  std::vector<Cells> columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Column& column = table.columns[i];
    if (column.label.empty()) continue;
    const std::string& unit = column.format.unit;
    Cells of{{printable(units_below ? column.label : heading(column))}};
    if (units_below) of.cells.push_back(unit.empty() ? "" : "[" + unit + "]");
    for (std::size_t row = 0; row < rows; ++row) {
      const Cell& cell = table.rows[row].at(i);
      of.cells.push_back(printable(written(cell.value, cell.format_in(column))));
      of.right &= !std::holds_alternative<std::string>(cell.value);
    }
    columns.push_back(std::move(of));
  }
  return columns;
}

std::string table_text(const Table& table, const std::string& indent) {
  const std::size_t rows = std::min(table.most, table.rows.size());
  std::vector<Cells> columns = cells_of(table, rows, false);
  if (columns.empty()) return {};
  if (rows == 0)
    return indent + wrapped(printable(table.title) + ": --json", indent.size(), 0) + "\n";
  std::size_t width = indent.size();
  for (const Cells& of : columns) width += of.width() + 2;
  if (width > render::columns() + 2 &&
      std::ranges::any_of(table.columns, [](const Column& of) { return !of.format.unit.empty(); }))
    columns = cells_of(table, rows, true);
  std::string all = table.title.empty() ? "" : indent + title_text(table.title) + "\n";
  const std::size_t headings = columns.front().cells.size() - rows,
                    most = table_columns() - std::min(table_columns(), indent.size());
  narrow(columns, most);
  const auto blocks = blocks_of(columns, most);
  for (const std::vector<Cells>& block : blocks)
    all += (&block == &blocks.front() ? "" : "\n") + block_text(block, headings, indent);
  return all + more(table.rows.size() - rows, indent);
}

std::string list_text(const List& list, const std::string& indent) {
  std::string all = indent + title_text(list.title) + "\n";
  std::size_t shown = 0, lines = 0;
  for (; shown < list.lines.size(); ++shown) {
    std::string text = "  " + printable(list.lines[shown]);
    lines += 1 + static_cast<std::size_t>(std::ranges::count(text, '\n'));
    if (shown > 0 && lines > list.most) break;
    if ((list.broken || table_columns() != std::string::npos) &&
        indent.size() + width_of(text) > columns()) {
      // Words behind a time stay behind it.
      const std::size_t first = text.find_first_not_of(' '), gap = text.find("  ", first);
      const std::size_t start = gap == std::string::npos ? first : gap + 2;
      const std::size_t column = indent.size() + start;
      all += indent + text.substr(0, start) +
             wrapped(text.substr(start), gap == std::string::npos ? column + 2 : column, column) +
             "\n";
      continue;
    }
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; ++at)
      text.insert(at + 1, indent + "    ");
    all += indent + text + "\n";
  }
  return all + more(list.lines.size() - shown, indent + "  ");
}

bool is_shown(const Table& table) {
  return !table.rows.empty() && std::ranges::any_of(table.columns, [](const Column& column) {
    return !column.label.empty();
  });
}

bool is_shown(const List& list) { return !list.lines.empty() && !list.title.empty(); }
bool is_shown(const Sentence&) { return true; }

using Shown = std::vector<const Part*>;

/// Prints text for people, sections without a title by their parts.
Shown shown_parts(const std::vector<Part>& parts) {
  Shown shown;
  for (const Part& part : parts) {
    const auto* section = std::get_if<Section>(&part);
    const bool titled = section != nullptr && !section->title.empty();
    if (section != nullptr) {
      const Shown inner = shown_parts(section->parts);
      if (titled && !inner.empty()) shown.push_back(&part);
      if (!titled) append_all(shown, inner);
    } else if (std::visit(
                   [](const auto& of) {
                     if constexpr (std::same_as<std::decay_t<decltype(of)>, Section>)
                       return false;
                     else
                       return is_shown(of);
                   },
                   static_cast<const Part::variant&>(part))) {
      shown.push_back(&part);
    }
  }
  return shown;
}

std::size_t label_width(const Shown& parts, std::size_t first) {
  std::size_t width = 0;
  for (std::size_t i = first; i < parts.size(); ++i) {
    const auto* fact = std::get_if<Fact>(parts[i]);
    if (fact == nullptr) break;
    width = std::max(width, width_of(printable(fact->label)));
  }
  return width;
}

/// A text of several lines, or that fits, stays as it is.
std::string fitted(const std::string& text, std::size_t column) {
  return column + width_of(text) <= columns() || text.find('\n') != std::string::npos
             ? text
             : wrapped(text, column, column);
}

/// Facts that follow each other stand below each other, as do sentences; an empty line goes around
/// every other block.
std::string parts_text(const Shown& parts, const std::string& indent) {
  std::string all;
  std::size_t width = 0;
  bool after_block = false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto* fact = std::get_if<Fact>(parts[i]);
    const auto* sentence = std::get_if<Sentence>(parts[i]);
    const bool is_line = fact != nullptr || sentence != nullptr;
    const bool begins_sentences =
        sentence != nullptr && i > 0 && std::holds_alternative<Fact>(*parts[i - 1]);
    if (i > 0 && (after_block || !is_line || begins_sentences)) all += "\n";
    after_block = !is_line;
    width = fact == nullptr ? 0 : width == 0 ? label_width(parts, i) : width;
    if (fact != nullptr)
      all += indent + padded(printable(fact->label), width, false) + "  " +
             fitted(value_text(*fact), indent.size() + width + 2) + "\n";
    if (sentence != nullptr)
      all += indent + wrapped(printable(sentence->text), indent.size(), indent.size()) + "\n";
    if (const auto* table = std::get_if<Table>(parts[i])) {
      const std::vector<Table> groups = groups_of(*table);
      for (const Table& group : groups)
        all += (&group == &groups.front() ? "" : "\n") + table_text(group, indent);
    }
    if (const auto* list = std::get_if<List>(parts[i])) all += list_text(*list, indent);
    if (const auto* section = std::get_if<Section>(parts[i]))
      all += indent + title_text(section->title) + "\n" +
             parts_text(shown_parts(section->parts), indent + "  ");
  }
  return all;
}

}  // namespace

std::string text(const Section& section) {
  return (section.title.empty() ? "" : title_text(section.title) + "\n") +
         parts_text(shown_parts(section.parts), "");
}

std::string text(const std::vector<Section>& sections) {
  std::string all;
  for (const Section& each : sections) all += (all.empty() ? "" : "\n") + text(each);
  return all;
}

std::string text(const Table& table) { return table_text(table, ""); }

}  // namespace gurney::render
