#include "groundmotions/formats/plain_rows.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "groundmotions/formats/end_mark.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr std::string_view kSeparators = ",;";
constexpr std::string_view kBetweenWords = " \t\v\f\x1a,;";
constexpr std::size_t kHeaderLines = 40;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// A word of a language rather than a number that went wrong (nan, inf, E-03).
bool is_text(std::string_view word) {
  while (!word.empty() && std::ispunct(static_cast<unsigned char>(word.front())))
    word.remove_prefix(1);
  while (!word.empty() && std::ispunct(static_cast<unsigned char>(word.back())))
    word.remove_suffix(1);
  if (word.empty() || !is_letter(word[0])) return false;
  if (word.size() > 1 && lower(word)[0] == 'e' && (is_digit(word[1]) || !is_letter(word[1])))
    return false;
  if (word.size() > 1 && lower(word)[0] == 'd' && (word[1] == '-' || word[1] == '+')) return false;
  constexpr std::array kNoNumbers = {"nan", "inf", "infinity", "na", "null", "none"};
  return std::ranges::find(kNoNumbers, lower(word)) == kNoNumbers.end();
}

/// Words, or a rule such as "-----"; stars may be a number that did not fit.
bool has_text(std::string_view line) {
  return std::ranges::any_of(words_of(line, kBetweenWords), is_text) ||
         line.find_first_not_of(" \t-=_#~+") == std::string_view::npos;
}

bool is_comment(std::string_view line) {
  line = trimmed(line);
  return line.starts_with('#') || line.starts_with('%') || line.starts_with("//");
}

bool is_blank(std::string_view line) { return trimmed(line).empty(); }

bool is_row(std::string_view line) {
  const auto words = words_of(line, kBetweenWords);
  return !words.empty() && std::ranges::all_of(words, [](std::string_view word) {
    // Numbers may stick together or lack the letter of their exponent; see NumberReader.
    return take_number(word).has_value() && (word.empty() || word[0] == '-' || word[0] == '+');
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

/// The first line that is neither blank, comment nor text; nothing if there is none early enough.
std::optional<std::size_t> first_row(const SourceFile& file) {
  std::size_t text = 0;
  for (std::size_t i = 0; i < file.lines().size() && text <= kHeaderLines; ++i) {
    const auto line = file.lines()[i];
    if (is_blank(line) || is_comment(line)) continue;
    if (!is_text_line(line)) return i;
    ++text;
  }
  return {};
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

}  // namespace

std::size_t PlainRows::width() const {
  if (lengths.empty()) return 0;
  for (std::size_t i = 1; i < lengths.size(); ++i)
    if (i + 1 < lengths.size() ? lengths[i] != lengths[0] : lengths[i] > lengths[0]) return 0;
  return lengths[0];
}

bool is_text_line(std::string_view line) {
  return !is_blank(line) && !is_row(line) && has_text(line);
}

bool has_plain_rows(const SourceFile& file) {
  const auto row = first_row(file);
  return row && is_row(file.lines()[*row]);
}

PlainRows plain_rows(const SourceFile& file, FileErrors& errors) {
  PlainRows rows;
  const std::size_t first = first_row(file).value_or(file.lines().size());
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

std::vector<std::string> column_titles(const PlainRows& rows, std::size_t count) {
  if (rows.header.empty()) return {};
  std::string_view line = rows.header.back();
  line.remove_prefix(std::min(line.find_first_not_of("#% \t"), line.size()));
  std::vector<std::vector<std::string_view>> partings;
  for (const std::string_view between : {";", ",", "\t", " \t"})
    partings.push_back(words_of(line, between));
  partings.push_back(apart_by_two_blanks(line));
  for (const auto& words : partings) {
    std::vector<std::string> titles;
    for (const auto word : words) {
      const auto text = trimmed(word);
      if (!titles.empty() && !text.empty() && (text[0] == '(' || text[0] == '['))
        titles.back() += std::string(text);
      else
        titles.emplace_back(text);
    }
    if (titles.size() == count) return titles;
  }
  return {};
}

}  // namespace gurney::groundmotions
