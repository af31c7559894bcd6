#include "groundmotions/formats/plain_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

#include "groundmotions/formats/numbers.h"
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
  return !is_one_of(lower(word), "nan inf infinity na null none");
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

/// A date and clock time that a line begins with.
struct Stamp {
  std::size_t begin = 0, end = 0;  ///< in the line
  std::string_view date;           ///< as written; may be empty
  double seconds = 0;              ///< since midnight
  std::size_t decimals = 0;        ///< of the seconds, as printed
};

std::size_t digits_at(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
}

/// "2010-02-27", "27/02/2010", "27.2.10"; its length, or 0.
std::size_t date_at(std::string_view text) {
  std::size_t at = digits_at(text);
  if (at == 0 || at > 4 || at >= text.size()) return 0;
  const char mark = text[at];
  if (mark != '-' && mark != '/' && mark != '.') return 0;
  for (int part = 0; part < 2; ++part) {
    if (at >= text.size() || text[at] != mark) return 0;
    const std::size_t digits = digits_at(text.substr(at + 1));
    if (digits == 0 || digits > 4) return 0;
    at += 1 + digits;
  }
  return at;
}

/// "06:34:14.005" or "34:14.005"; sets the seconds and returns its length, or 0.
std::size_t clock_at(std::string_view text, Stamp& stamp) {
  std::size_t at = 0;
  double value = 0;
  int colons = 0;
  for (;; ++colons) {
    const std::size_t digits = digits_at(text.substr(at));
    if (digits == 0 || digits > 2) return 0;
    value = 60 * value + number(text.substr(at, digits)).value_or(0);
    at += digits;
    if (at >= text.size() || text[at] != ':') break;
    ++at;
  }
  if (colons == 0 || colons > 2) return 0;
  if (at < text.size() && text[at] == '.') {
    stamp.decimals = digits_at(text.substr(at + 1));
    const std::string fraction = "0" + std::string(text.substr(at, 1 + stamp.decimals));
    value += number(fraction).value_or(0);
    at += 1 + stamp.decimals;
  }
  if (at < text.size() && text[at] == 'Z') ++at;
  stamp.seconds = value;
  return at;
}

std::optional<Stamp> stamp_of(std::string_view line) {
  Stamp stamp;
  stamp.begin = std::min(line.find_first_not_of(" \t\""), line.size());
  std::size_t at = stamp.begin;
  if (const std::size_t length = date_at(line.substr(at)); length > 0) {
    stamp.date = line.substr(at, length);
    at += length;
    const std::size_t clock = line.find_first_not_of(" \tT,;", at);
    if (clock == kNone || clock == at) return {};
    at = clock;
  }
  const std::size_t length = clock_at(line.substr(at), stamp);
  stamp.end = at + length;
  const bool is_apart =
      stamp.end < line.size() && std::string_view(" \t,;\"").find(line[stamp.end]) != kNone;
  return length > 0 && is_apart ? std::optional(stamp) : std::nullopt;
}

/// The lines of a file, which may be replaced by others as long.
class Lines {
 public:
  explicit Lines(const SourceFile& file) : bytes_(file.bytes()), original_(file.bytes().data()) {
    for (const std::string_view line : file.lines())
      lines_.emplace_back(static_cast<std::size_t>(line.data() - original_), line.size());
  }
  std::size_t size() const { return lines_.size(); }
  std::string_view operator[](std::size_t i) const {
    return std::string_view(bytes_).substr(lines_[i].first, lines_[i].second);
  }
  void set(std::size_t line, std::size_t column, char c) {
    bytes_[lines_[line].first + column] = c;
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  const char* original_;
  std::vector<std::pair<std::size_t, std::size_t>> lines_;  ///< begin and length
};

/// A number with a comma for its point, or without either: "-0,012", "5", "1,2E-3".
bool is_comma_number(std::string_view cell) {
  if (cell.find('.') != kNone || std::ranges::count(cell, ',') > 1) return false;
  const auto comma = cell.find(',');
  const bool has_digit = comma == kNone || (comma + 1 < cell.size() && is_digit(cell[comma + 1]));
  std::string text(cell);
  if (comma != kNone) text[comma] = '.';
  return has_digit && number(text).has_value();
}

/// Quotes become blanks; within them commas and semicolons do not part cells.
void unquote(Lines& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    bool inside = false;
    std::size_t open = 0;
    for (std::size_t k = 0; k < lines[i].size(); ++k) {
      if (lines[i][k] != '"') continue;
      const auto cell = lines[i].substr(open + 1, k - open - 1);
      const bool is_number = inside && is_comma_number(trimmed(cell));
      for (std::size_t m = open + 1; inside && m < k; ++m)
        if (lines[i][m] == ',' || lines[i][m] == ';') lines.set(i, m, is_number ? '.' : ' ');
      lines.set(i, k, ' ');
      if (inside) lines.set(i, open, ' ');
      inside = !inside;
      open = k;
    }
  }
}

/// Seconds from the first row in place of dates and clock times.
bool set_seconds(Lines& lines, std::size_t first, std::string& first_time) {
  const auto start = stamp_of(lines[first]);
  if (!start) return false;
  const auto last = std::min(first + 1, lines.size() - 1);
  if (!stamp_of(lines[last])) return false;
  first_time = lines[first].substr(start->begin, start->end - start->begin);
  std::string date(start->date);
  double before = start->seconds, midnight = 0;
  std::vector<std::pair<std::size_t, std::string>> cells;
  std::vector<Stamp> stamps;
  for (std::size_t i = first; i < lines.size(); ++i) {
    const auto stamp = stamp_of(lines[i]);
    if (!stamp) continue;
    constexpr double kHalfDay = 12 * 3600, kDay = 24 * 3600;
    const bool is_next_day = stamp->seconds < before - kHalfDay;
    if (stamp->date != date && !is_next_day) return false;  // days are missing
    if (is_next_day) midnight += kDay;
    date = stamp->date;
    before = stamp->seconds;
    const double time = midnight + stamp->seconds - start->seconds;
    cells.emplace_back(i, fmt::format("{:.{}f}", time, std::min<std::size_t>(stamp->decimals, 9)));
    if (cells.back().second.size() > stamp->end - stamp->begin) return false;
    stamps.push_back(*stamp);
  }
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto& [line, text] = cells[k];
    for (std::size_t at = stamps[k].begin; at < stamps[k].end; ++at) {
      const std::size_t digit = at - stamps[k].begin;
      lines.set(line, at, digit < text.size() ? text[digit] : ' ');
    }
  }
  return true;
}

/// The cells of a row by the only mark that parts them, or nothing if commas may do so too.
std::vector<std::string_view> cells_beside_commas(std::string_view line, char mark) {
  std::vector<std::string_view> cells;
  for (const auto cell : words_of(line, mark == ' ' ? " \t" : std::string_view(&mark, 1)))
    if (const auto text = trimmed(cell); !text.empty()) cells.push_back(text);
  return cells;
}

bool has_comma_between_digits(std::string_view line) {
  for (auto at = line.find(','); at != kNone; at = line.find(',', at + 1))
    if (at > 0 && at + 1 < line.size() && is_digit(line[at - 1]) && is_digit(line[at + 1]))
      return true;
  return false;
}

/// Whether semicolons, tabs or blanks part the cells of every row, so that commas mark decimals.
bool has_decimal_commas(const Lines& lines, std::size_t first, char mark) {
  bool commas = false;
  for (std::size_t i = first; i < lines.size(); ++i) {
    const auto line = trimmed(lines[i]);
    if (line.empty() || line[0] == '#' || line[0] == '%') continue;
    const auto cells = cells_beside_commas(line, mark);
    if (std::ranges::all_of(cells, is_comma_number) && (mark == ';' || cells.size() > 1))
      commas = commas || line.find(',') != kNone;
    else if (!is_text_line(line))
      return false;
  }
  return commas;
}

void set_points(Lines& lines, std::size_t first, PlainCells& result) {
  const auto row = lines[first];
  const char mark = row.find(';') != kNone ? ';' : row.find('\t') != kNone ? '\t' : ' ';
  result.decimal_commas = has_decimal_commas(lines, first, mark);
  if (!result.decimal_commas) {
    bool commas = false, points = false;
    for (std::size_t i = first; mark == ';' && i < lines.size() && !(commas && points); ++i) {
      commas = commas || has_comma_between_digits(lines[i]);
      points = points || lines[i].find('.') != kNone;
    }
    result.mixed_marks = commas && points;
    return;
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = 0; k + 1 < lines[i].size(); ++k)
      if (lines[i][k] == ',' && is_digit(lines[i][k + 1]) &&
          (i >= first || (k > 0 && is_digit(lines[i][k - 1]))))
        lines.set(i, k, '.');
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

bool is_dated_row(std::string_view line) {
  const auto stamp = stamp_of(line);
  if (!stamp) return false;
  const auto words = words_of(line.substr(stamp->end), " \t,;\"");
  return !words.empty() &&
         std::ranges::all_of(words, [](auto word) { return number(word).has_value(); });
}

PlainCells plain_cells(const SourceFile& file) {
  PlainCells result;
  const auto row = first_plain_row(file);
  if (!row) return result;
  const bool quotes = file.bytes().find('"') != kNone;
  const bool dated = is_dated_row(file.lines()[*row]);
  const bool commas = file.lines()[*row].find(',') != kNone ||
                      (*row + 1 < file.lines().size() && file.lines()[*row + 1].find(',') != kNone);
  if (!quotes && !dated && !commas) return result;
  Lines lines(file);
  if (quotes) unquote(lines);
  if (dated) set_seconds(lines, *row, result.first_time);
  if (commas || quotes) set_points(lines, *row, result);
  if (quotes || !result.first_time.empty() || result.decimal_commas)
    result.file = std::make_unique<SourceFile>(file.name(), lines.take());
  return result;
}

}  // namespace gurney::groundmotions
