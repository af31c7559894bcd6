#include "groundmotions/formats/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

bool is_sign(char c) { return c == '+' || c == '-'; }

/// A sign and three digits, and then no further part of a number.
bool is_bare_exponent(std::string_view text) {
  return text.size() >= 4 && is_sign(text[0]) && is_digit(text[1]) && is_digit(text[2]) &&
         is_digit(text[3]) && (text.size() == 4 || is_sign(text[4]));
}

bool is_end_mark(std::string_view line) {
  return std::ranges::any_of(words_of(line, " \t\v\f\x1a,;*-=#%.!"), [](std::string_view word) {
    const std::string text = lower(word);
    return text == "end" || text == "eof" || text.starts_with("end_");
  });
}

}  // namespace

Eigen::VectorXd scaled(const std::vector<double>& values, double factor) {
  return factor *
         Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

NumberReader::NumberReader(const SourceFile& file, FileErrors& errors, std::string_view separators)
    : file_(file), errors_(errors), separates_() {
  for (const std::string_view texts : {std::string_view(kNumberBlanks), separators})
    for (const unsigned char c : texts) separates_[c] = true;
}

std::size_t NumberReader::read_line(std::size_t index) {
  const std::string_view line = file_.lines()[index];
  const std::size_t before = line_begin_ = values_.size();
  Layout layout;
  const auto separates = [&](std::size_t i) {
    return separates_[static_cast<unsigned char>(line[i])];
  };
  for (std::size_t end = 0; end < line.size();) {
    std::size_t begin = end;
    while (begin < line.size() && separates(begin)) ++begin;
    if (begin == line.size()) break;
    end = begin;
    while (end < line.size() && !separates(end)) ++end;
    read_word(line.substr(begin, end - begin), index + 1, begin + 1);
    layout.emplace_back(begin, end);
  }
  if (!layout.empty()) compare(layout);
  return values_.size() - before;
}

void NumberReader::compare(const Layout& layout) {
  if (layout_.empty()) {
    layout_ = layout;
    // Columns of one width, as in Fortran, with numbers of several lengths.
    for (std::size_t k = 2; k < layout.size(); ++k) {
      const auto width = layout[k].second - layout[k - 1].second;
      if (width != layout[1].second - layout[0].second) return;
      is_flush_right_ = is_flush_right_ || layout[k].first - layout[k - 1].first != width;
    }
    return;
  }
  all_in_columns_ = all_in_columns_ && last_in_columns_;
  last_in_columns_ = layout.size() <= layout_.size();
  for (std::size_t k = 0; last_in_columns_ && k < layout.size(); ++k) {
    last_in_columns_ = layout[k].second == layout_[k].second;
    if (last_in_columns_ && layout[k].first != layout_[k].first) is_flush_right_ = true;
  }
}

void NumberReader::keep_tail() {
  if (last_column_ >= shortest_tails_.size())
    shortest_tails_.resize(last_column_ + 1, std::string_view::npos);
  shortest_tails_[last_column_] = std::min(shortest_tails_[last_column_], last_tail_);
}

void NumberReader::read_word(std::string_view word, std::size_t line, std::size_t column) {
  std::string_view rest = word;
  while (!rest.empty()) {
    const std::string_view start = rest;
    auto value = take_number(rest);
    if (value && is_bare_exponent(rest)) {
      const auto mantissa = start.substr(0, start.size() - rest.size());
      value = number(fmt::format("{}E{}", mantissa, rest.substr(0, 4)));
      rest.remove_prefix(4);
    }
    const std::string_view text = start.substr(0, start.size() - rest.size());
    const auto point = text.find('.');
    const bool glued = start.size() < word.size() || !rest.empty();
    const bool ends_well = rest.empty() || is_sign(rest[0]);
    if (!value || !ends_well || (glued && point == std::string_view::npos)) {
      errors_.add(line, column + (word.size() - start.size()),
                  fmt::format("'{}' is not a finite number", word.substr(0, 40)));
      return;
    }
    if (!values_.empty()) keep_tail();
    values_.push_back(*value);
    last_column_ = values_.size() - 1 - line_begin_;
    last_tail_ = point == std::string_view::npos ? 0 : text.size() - point;
  }
}

void NumberReader::check_end() const {
  if (file_.ends_with_line_end() || values_.size() < 2) return;
  const bool is_short =
      last_column_ < shortest_tails_.size() && last_tail_ < shortest_tails_[last_column_];
  const bool ends_early = is_flush_right_ && all_in_columns_ && !last_in_columns_;
  if (!is_short && !ends_early) return;
  errors_.add(file_.lines().size(), file_.lines().back().size(),
              fmt::format("the file ends within a line and its last number {}: the file seems to "
                          "be cut",
                          is_short ? "is shorter than all others" : "ends left of its column"));
}

std::size_t data_end(const SourceFile& file, std::size_t first) {
  std::size_t last = file.lines().size();
  const auto skip_blanks = [&] {
    while (last > first && is_blank(file.lines()[last - 1])) --last;
  };
  for (skip_blanks(); last > first && is_end_mark(file.lines()[last - 1]); skip_blanks()) --last;
  return last;
}

void read_to_end(const SourceFile& file, std::size_t first, NumberReader& reader) {
  const std::size_t end = data_end(file, first);
  for (std::size_t i = first; i < end; ++i) reader.read_line(i);
  const auto rest = file.lines().begin() + static_cast<std::ptrdiff_t>(end);
  if (std::all_of(rest, file.lines().end(), is_blank)) reader.check_end();
}

}  // namespace gurney::groundmotions
