#include "groundmotions/formats/plain_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/plain_rows.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

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
