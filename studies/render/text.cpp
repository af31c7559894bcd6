#include <fmt/format.h>

#include <algorithm>

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

bool is_shown(const Fact& fact) { return !fact.label.empty() && !fact.value.is_missing(); }

std::string value_text(const Fact& fact) {
  return with_unit(fact.value, fact.format) + (fact.note.empty() ? "" : ", " + fact.note);
}

std::string more(std::size_t count, const std::string& indent) {
  return count == 0 ? "" : fmt::format("{}and {} more; --json lists all\n", indent, count);
}

std::string table_text(const Table& table, const std::string& indent) {
  struct Cells {
    Texts cells;
    std::size_t width;
    bool right;
  };
  const std::size_t rows = std::min(table.most, table.rows.size());
  std::vector<Cells> columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i].label.empty()) continue;
    Cells of{{heading(table.columns[i])}, 0, true};
    for (std::size_t row = 0; row < rows; ++row) {
      const Cell& cell = table.rows[row].at(i);
      of.cells.push_back(written(cell.value, cell.format_in(table.columns[i])));
      of.right &= !std::holds_alternative<std::string>(cell.value);
    }
    for (const std::string& each : of.cells) of.width = std::max(of.width, width_of(each));
    columns.push_back(std::move(of));
  }
  if (columns.empty()) return {};
  if (rows == 0) return indent + wrapped(table.title + ": --json", indent.size(), 0) + "\n";
  std::string all = table.title.empty() ? "" : indent + table.title + "\n";
  for (std::size_t row = 0; row <= rows; ++row) {
    std::string line;
    for (const Cells& of : columns)
      line += (line.empty() ? indent : "  ") + padded(of.cells[row], of.width, of.right);
    all += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return all + more(table.rows.size() - rows, indent);
}

std::string list_text(const List& list, const std::string& indent) {
  std::string all = indent + list.title + "\n";
  std::size_t shown = 0, lines = 0;
  for (; shown < list.lines.size(); ++shown) {
    std::string text = "  " + list.lines[shown];
    lines += 1 + static_cast<std::size_t>(std::ranges::count(text, '\n'));
    if (shown > 0 && lines > list.most) break;
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

/// What people read, sections without a title by their parts.
Shown shown_parts(const std::vector<Part>& parts) {
  Shown shown;
  for (const Part& part : parts) {
    const auto* section = std::get_if<Section>(&part);
    const bool titled = section != nullptr && !section->title.empty();
    if (section != nullptr) {
      const Shown inner = shown_parts(section->parts);
      if (titled && !inner.empty()) shown.push_back(&part);
      if (!titled) shown.insert(shown.end(), inner.begin(), inner.end());
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
    width = std::max(width, width_of(fact->label));
  }
  return width;
}

/// Facts that follow each other stand below each other; an empty line goes around every other
/// block but sentences.
std::string parts_text(const Shown& parts, const std::string& indent) {
  std::string all;
  std::size_t width = 0;
  bool after_block = false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto* fact = std::get_if<Fact>(parts[i]);
    const auto* sentence = std::get_if<Sentence>(parts[i]);
    const bool is_line = fact != nullptr || sentence != nullptr;
    if (i > 0 && (after_block || !is_line)) all += "\n";
    after_block = !is_line;
    width = fact == nullptr ? 0 : width == 0 ? label_width(parts, i) : width;
    if (fact != nullptr)
      all += indent + padded(fact->label, width, false) + "  " + value_text(*fact) + "\n";
    if (sentence != nullptr)
      all += indent + wrapped(sentence->text, indent.size(), indent.size()) + "\n";
    if (const auto* table = std::get_if<Table>(parts[i])) {
      const std::vector<Table> groups = groups_of(*table);
      for (const Table& group : groups)
        all += (&group == &groups.front() ? "" : "\n") + table_text(group, indent);
    }
    if (const auto* list = std::get_if<List>(parts[i])) all += list_text(*list, indent);
    if (const auto* section = std::get_if<Section>(parts[i]))
      all +=
          indent + section->title + "\n" + parts_text(shown_parts(section->parts), indent + "  ");
  }
  return all;
}

}  // namespace

std::string text(const Section& section) {
  return (section.title.empty() ? "" : section.title + "\n") +
         parts_text(shown_parts(section.parts), "");
}

std::string text(const std::vector<Section>& sections) {
  std::string all;
  for (const Section& each : sections) all += (all.empty() ? "" : "\n") + text(each);
  return all;
}

std::string text(const Table& table) { return table_text(table, ""); }

}  // namespace gurney::render
