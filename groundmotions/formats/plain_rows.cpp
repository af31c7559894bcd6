#include "groundmotions/formats/plain_rows.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "groundmotions/formats/end_mark.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/plain_cells.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr std::string_view kSeparators = ",;";
constexpr std::string_view kBetweenWords = " \t\v\f\x1a,;\"";
constexpr std::size_t kHeaderLines = 40;

/// A word of another script; "\u2212" and blanks of Unicode (C2, E2) are none.
bool is_foreign_word(std::string_view word) {
  const auto first = static_cast<unsigned char>(word[0]);
  return first >= 0x80 && first != 0xc2 && first != 0xe2 && std::ranges::none_of(word, is_digit);
}

/// A word of a language rather than a number that went wrong (nan, inf, E-03).
bool is_text(std::string_view word) {
  while (!word.empty() && std::ispunct(static_cast<unsigned char>(word.front())))
    word.remove_prefix(1);
  while (!word.empty() && std::ispunct(static_cast<unsigned char>(word.back())))
    word.remove_suffix(1);
  if (word.empty()) return false;
  if (is_foreign_word(word)) return true;
  if (!is_letter(word[0])) return false;
  if (word.size() > 1 && lower(word)[0] == 'e' && (is_digit(word[1]) || !is_letter(word[1])))
    return false;
  if (word.size() > 1 && lower(word)[0] == 'd' && (word[1] == '-' || word[1] == '+')) return false;
  constexpr std::array kNoNumbers = {"nan", "inf", "infinity", "na", "null", "none"};
  return std::ranges::find(kNoNumbers, lower(word)) == kNoNumbers.end();
}

/// A word such as "065JZC" or "2nd": it begins with a digit and has two letters in a row.
bool is_label(std::string_view word) {
  if (!is_digit(word[0]) || word.find('#') != std::string_view::npos || word.starts_with("0x"))
    return false;
  const std::string text = lower(word);
  if (text.find("nan") != std::string::npos || text.find("inf") != std::string::npos) return false;
  for (std::size_t i = 1; i < word.size(); ++i)
    if (is_letter(word[i - 1]) && is_letter(word[i])) return true;
  return false;
}

/// A date or a clock time: 27/02/2010, 2010-02-27, 27.02.2010, 06:34, 06:34:14.5.
bool is_date(std::string_view word) {
  const auto digits = [](std::string_view part) {
    return part.find_first_not_of("0123456789") == std::string_view::npos;
  };
  for (const char mark : {':', '/', '-', '.'}) {
    if (std::ranges::count(word, mark) > 2) continue;
    auto parts = words_of(word, std::string_view(&mark, 1));
    if (mark == ':' && parts.size() > 1) {
      parts.back() = parts.back().substr(0, parts.back().find('.'));
      if (std::ranges::all_of(parts, digits)) return true;
    }
    if (parts.size() != 3 || !std::ranges::all_of(parts, digits)) continue;
    // "0.12.34" is a damaged number.
    if (parts[2].size() == 4 || (mark != '.' && mark != ':')) return true;
  }
  return false;
}

/// Words of a language, names that begin with a digit, dates, or a rule.
bool has_text(std::string_view line) {
  const auto words = words_of(line, kBetweenWords);
  if (std::ranges::any_of(words, is_text) || is_rule(line)) return true;
  const bool has_point = std::ranges::any_of(words, [](std::string_view word) {
    return word.find('.') != std::string_view::npos && take_number(word) && word.empty();
  });
  return std::ranges::any_of(words, is_date) ||
         (!has_point && std::ranges::any_of(words, is_label));
}

bool is_comment(std::string_view line) {
  line = trimmed(line);
  return line.starts_with('#') || line.starts_with('%') || line.starts_with("//");
}

bool is_row(std::string_view line) {
  const auto words = words_of(line, kBetweenWords);
  return !words.empty() && std::ranges::all_of(words, [](std::string_view word) {
    // Numbers may stick together or lack the letter of their exponent; see NumberReader.
    return !is_date(word) && take_number(word).has_value() &&
           (word.empty() || word[0] == '-' || word[0] == '+');
  });
}

/// Where a comma or semicolon has nothing before it (from 1), or 0.
std::size_t empty_cell(std::string_view line) {
  bool empty = true;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool separator = kSeparators.find(line[i]) != std::string_view::npos;
    if (separator && empty) return i + 1;
    if (separator || !is_blank(line.substr(i, 1))) empty = separator;
  }
  return 0;
}

std::string_view next_line(const SourceFile& file, std::size_t i) {
  while (++i < file.lines().size())
    if (!is_blank(file.lines()[i])) return file.lines()[i];
  return {};
}

/// A line of stars alone parts a header, unless it may be a sample that did not fit its column.
bool is_rule_of_stars(const SourceFile& file, std::size_t i) {
  constexpr std::size_t kWidestField = 20;
  const auto line = trimmed(file.lines()[i]);
  if (line.empty() || line.find_first_not_of("* \t") != std::string_view::npos) return false;
  if (line.find(std::string(kWidestField + 1, '*')) != std::string_view::npos) return true;
  const auto next = next_line(file, i);
  if (is_text_line(next) || is_comment(next) || trimmed(next).starts_with('*')) return true;
  return words_of(next, kBetweenWords).size() > 1 && words_of(line, " \t").size() == 1;
}

}  // namespace

std::size_t PlainRows::width() const {
  if (lengths.empty()) return 0;
  for (std::size_t i = 1; i < lengths.size(); ++i)
    if (i + 1 < lengths.size() ? lengths[i] != lengths[0] : lengths[i] > lengths[0]) return 0;
  return lengths[0];
}

bool is_rule(std::string_view line) {
  return line.find_first_not_of(" \t-=_#~+*|") == std::string_view::npos &&
         line.find_first_of("-=_#~+") != std::string_view::npos;
}

bool is_text_line(std::string_view line) {
  constexpr std::size_t kEnough = 10000;  ///< characters of a line that decide
  line = line.substr(0, kEnough);
  return !is_blank(line) && !is_row(line) && !is_dated_row(line) && has_text(line);
}

std::optional<std::size_t> first_plain_row(const SourceFile& file) {
  std::size_t text = 0;
  for (std::size_t i = 0; i < file.lines().size() && text <= kHeaderLines; ++i) {
    const auto line = file.lines()[i];
    if (is_blank(line) || is_comment(line)) continue;
    if (!is_text_line(line) && !is_rule_of_stars(file, i)) return i;
    ++text;
  }
  return {};
}

bool has_plain_rows(const SourceFile& file) {
  const auto row = first_plain_row(file);
  return row && (is_row(file.lines()[*row]) || is_dated_row(file.lines()[*row]));
}

std::optional<PlainFault> plain_fault(const SourceFile& file) {
  const auto row = first_plain_row(file);
  if (!row) return {};
  const auto line = file.lines()[*row];
  for (auto word : words_of(line, kBetweenWords)) {
    const auto begin = static_cast<std::size_t>(word.data() - line.data());
    if (take_number(word) && (word.empty() || word[0] == '-' || word[0] == '+')) continue;
    return PlainFault{*row + 1, begin + 1};
  }
  return PlainFault{*row + 1, 1};
}

PlainRows plain_rows(const SourceFile& file, FileErrors& errors) {
  PlainRows rows;
  const std::size_t first = first_plain_row(file).value_or(file.lines().size());
  for (std::size_t i = 0; i < first; ++i)
    if (!is_blank(file.lines()[i])) {
      rows.header.push_back(trimmed(file.lines()[i]));
      rows.header_lines.push_back(i + 1);
    }

  const std::size_t last = data_end(file, first);
  for (std::size_t i = last; i < file.lines().size(); ++i)
    if (!is_blank(file.lines()[i])) rows.end.push_back(trimmed(file.lines()[i]));

  bool commas = false, points = false;
  NumberReader reader(file, errors, kSeparators);
  for (std::size_t i = first; i < last; ++i) {
    const auto line = file.lines()[i];
    if (is_blank(line) || is_comment(line)) continue;
    if (const auto column = empty_cell(line); column > 0)
      errors.add(i + 1, column, "an empty cell");
    commas = commas || line.find(',') != std::string_view::npos;
    points = points || line.find('.') != std::string_view::npos;
    const std::size_t length = reader.read_line(i);
    if (length == 0) continue;
    rows.lengths.push_back(length);
    rows.lines.push_back(i + 1);
  }
  if (rows.end.empty()) reader.check_end();
  rows.values = reader.values();
  rows.doubtful_commas = commas && !points;
  return rows;
}

}  // namespace gurney::groundmotions
