#include "groundmotions/formats/table_titles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/unit_text.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

/// The cells of one line of text.
struct Cells {
  std::vector<std::string> texts;
  bool by_blanks = false;  ///< single blanks part them, as they part the words of a sentence
};

bool in_brackets_whole(std::string_view text) {
  return text.size() > 1 && std::string_view("([").find(text.front()) != kNone &&
         text.find_first_of(")]") == text.size() - 1;
}

std::string_view without_mark(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of("#%/ \t"), line.size()));
  return line;
}

std::vector<std::string_view> apart_by_two_blanks(std::string_view line) {
  std::vector<std::string_view> words;
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const auto end = std::min({line.find("  "), line.find('\t'), line.size()});
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

/// Between any two marks, also where nothing stands there; a mark at the end parts nothing.
std::vector<std::string_view> apart_by_mark(std::string_view line, char mark) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const auto end = std::min(line.find(mark, begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  if (cells.size() > 1 && cells.back().empty()) cells.pop_back();
  return cells;
}

/// A bracket belongs to the word before it, unless all words are in brackets.
std::vector<std::string> with_brackets(const std::vector<std::string_view>& words) {
  const bool all = std::ranges::all_of(words, in_brackets_whole);
  std::vector<std::string> cells;
  for (const auto word : words) {
    const auto text = trimmed(word);
    const bool is_bracket = !text.empty() && (text[0] == '(' || text[0] == '[');
    // "(m / s2)" was cut at its blanks.
    const bool is_open = !cells.empty() && cells.back().find_last_of("([") != kNone &&
                         (cells.back().find_last_of(")]") == kNone ||
                          cells.back().find_last_of(")]") < cells.back().find_last_of("(["));
    if (!cells.empty() && (is_open || (is_bracket && !all)))
      cells.back() += std::string(text);
    else
      cells.emplace_back(text);
  }
  return cells;
}

/// Units that stand alone belong to the word before them: `Time, s, Acc, m/s2`.
std::vector<std::string> with_lone_units(const std::vector<std::string>& cells) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (const std::string& cell = cells[i];
        lower(cell) == "in" && i + 1 < cells.size() && is_unit_of_something(cells[i + 1]))
      continue;  // "acc in g"
    else if (!result.empty() && is_unit_of_something(cell) && !number(result.back()))
      result.back() += " [" + cell + "]";
    else
      result.push_back(cell);
  return result;
}

std::optional<Cells> cells_of(std::string_view line, std::size_t count) {
  constexpr std::size_t kLongestLine = 10000;
  if (line.size() > kLongestLine) return {};
  line = without_mark(line);
  std::vector<Cells> partings;
  for (const char mark : {';', ',', '\t'})
    if (line.find(mark) != kNone) {
      partings.push_back({with_brackets(apart_by_mark(line, mark)), false});
      partings.push_back({with_brackets(words_of(line, std::string_view(&mark, 1))), false});
    }
  partings.push_back({with_brackets(words_of(line, " \t")), true});
  partings.push_back({with_brackets(apart_by_two_blanks(line)), false});
  for (const Cells& cells : partings)
    if (cells.texts.size() == count) return cells;
  for (Cells& cells : partings) {
    cells.texts = with_lone_units(cells.texts);
    if (cells.texts.size() == count) return cells;
  }
  return {};
}

bool is_empty_cell(std::string_view text) {
  return text.empty() || text == "-" || text == "--" || text == "()" || text == "[]";
}

/// `[s] [g] [cm/s]`, `(s),(g),(cm)`, `s,g`, `sec,g,g,in`.
bool is_unit_row(const Cells& cells) {
  const auto is_unit = [](const std::string& text) {
    return is_empty_cell(text) || in_brackets_whole(text) || is_unit_of_something(text);
  };
  return std::ranges::all_of(cells.texts, is_unit) &&
         std::ranges::any_of(cells.texts, is_unit_of_something);
}

/// `Units: g`, `cm/s2; dt=0.01`, `recorded in g`, `Acc m/s2`: no titles although the words fit.
bool is_statement(const Cells& cells) {
  constexpr std::array<std::string_view, 13> kLinks = {
      "in", "of", "at", "from", "the", "and", "by", "for", "is", "with", "to", "on", "are"};
  constexpr std::array<std::string_view, 12> kKeys = {
      "unit",  "dt",   "npts",   "time step", "sampling",  "station",
      "event", "date", "record", "file",      "component", "channels"};
  const auto& texts = cells.texts;
  const std::string first = lower(texts[0]);
  const auto has_key = [&](std::string_view key) {
    return first.starts_with(key) && first.find(':') != std::string::npos;
  };
  if (std::ranges::any_of(kKeys, has_key) || first.ends_with(':')) return true;
  for (const std::string& text : texts) {
    if (text.find('=') != std::string::npos) return true;
    const bool is_link =
        text.ends_with(':') || std::ranges::find(kLinks, lower(text)) != kLinks.end();
    if (cells.by_blanks && is_link) return true;
  }
  return cells.by_blanks && quantity_in(texts[0]) == "acceleration" &&
         std::ranges::any_of(texts.begin() + 1, texts.end(),
                             [](const auto& text) { return acceleration_unit(text).has_value(); });
}

/// Words of a sentence are no titles if the first of them names neither a time nor an index.
bool may_be_titles(const Cells& cells, bool first_grows) {
  if (is_statement(cells) || is_unit_row(cells)) return false;
  if (!cells.by_blanks || !first_grows) return true;
  const auto titles = parsed_titles(cells.texts);
  const bool has_unit = std::ranges::any_of(
      titles, [](const ColumnTitle& title) { return is_unit_of_something(title.unit); });
  const bool is_ascii = std::ranges::all_of(
      cells.texts[0], [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  return has_unit || !is_ascii || names_time(titles[0]) || names_index(titles[0]) ||
         names_period(titles[0]) || titles[0].name.size() == 1;
}

bool first_grows(const PlainRows& rows, std::size_t count) {
  for (std::size_t i = count; i < rows.values.size(); i += count)
    if (!(rows.values[i] > rows.values[i - count])) return false;
  return rows.lengths.size() > 1;
}

/// Units of a row of their own stand behind the names; those that the names have stay too.
std::vector<std::string> with_units(std::vector<std::string> names,
                                    const std::vector<std::string>& units) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!is_empty_cell(units[i])) {
      const std::string_view unit = units[i];
      const bool whole = in_brackets_whole(unit);
      names[i] += fmt::format("{}[{}]", names[i].empty() ? "" : " ",
                              whole ? unit.substr(1, unit.size() - 2) : unit);
    }
  return names;
}

/// A line of the header that has one cell for each column.
struct Row {
  std::size_t line = 0;
  Cells cells;
};

TableTitles titles_of(const std::vector<std::string>& names, std::vector<std::size_t> lines,
                      const PlainRows& rows) {
  TableTitles result;
  result.titles = parsed_titles(names);
  result.line = rows.header_lines[*std::ranges::max_element(lines)];
  result.lines = std::move(lines);
  return result;
}

/// `components: E N Z`, for as many columns or all but the first.
TableTitles named_components(const PlainRows& rows, std::size_t count) {
  for (std::size_t i = 0; i < rows.header.size(); ++i) {
    const std::string line = lower(without_mark(rows.header[i]));
    const auto mark = line.find_first_of(":=");
    if (mark == std::string::npos) continue;
    const auto key = trimmed(std::string_view(line).substr(0, mark));
    if (!key.ends_with("components") && !key.ends_with("channels") && !key.ends_with("columns") &&
        key != "component order" && key != "component" && key != "order")
      continue;
    const auto text = without_mark(rows.header[i]).substr(mark + 1);
    std::vector<std::string> names;
    for (const auto word : words_of(text, " \t,;/")) names.emplace_back(word);
    if (names.size() + 1 == count && first_grows(rows, count)) names.insert(names.begin(), "time");
    if (names.size() != count || count < 2) continue;
    TableTitles result = titles_of(names, {i}, rows);
    result.are_components = true;
    return result;
  }
  return {};
}

}  // namespace

TableTitles table_titles(const PlainRows& rows, std::size_t count) {
  constexpr std::size_t kSearched = 6;  ///< lines above the numbers
  const bool grows = first_grows(rows, count);
  std::optional<Row> units, names;
  std::size_t seen = 0;
  for (std::size_t i = rows.header.size(); i-- > 0 && seen < kSearched && !names;) {
    if (is_rule(without_mark(rows.header[i])) || without_mark(rows.header[i]).empty()) continue;
    ++seen;
    const auto cells = cells_of(rows.header[i], count);
    if (!cells) continue;
    if (!units && is_unit_row(*cells)) {
      units = {i, *cells};
    } else if (may_be_titles(*cells, grows)) {
      // Far from the numbers only what names a time or a unit is surely no place and date.
      const auto titles = parsed_titles(cells->texts);
      const bool is_sure =
          names_time(titles[0]) || names_index(titles[0]) ||
          std::ranges::any_of(titles, [](const auto& t) { return is_unit_of_something(t.unit); });
      const bool is_next = seen == 1 || (units && units->line == i + 1);
      if (is_next || is_sure) names = {i, *cells};
    }
  }
  // Units may stand above the names.
  if (names && !units && names->line > 0)
    if (const auto above = cells_of(rows.header[names->line - 1], count);
        above && is_unit_row(*above))
      units = {names->line - 1, *above};
  if (names && units)
    return titles_of(with_units(names->cells.texts, units->cells.texts), {names->line, units->line},
                     rows);
  if (names) return titles_of(names->cells.texts, {names->line}, rows);
  if (units)
    return titles_of(with_units(std::vector<std::string>(count), units->cells.texts), {units->line},
                     rows);
  return named_components(rows, count);
}

}  // namespace gurney::groundmotions
