#include "groundmotions/formats/fortran_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

#include "engine/base/append_all.h"
#include "groundmotions/formats/numbers.h"

namespace gurney::groundmotions {

namespace {

constexpr std::size_t kWidest = 40;  ///< a number has no more characters
constexpr std::size_t kMaxPerLine = 200;

std::optional<std::size_t> take_count(std::string_view& text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

/// The number in a field. Fortran ignores a blank behind the letter of an exponent ("1.5E 00") and
/// may write D for E. Samples always have a point: without one they are a part of a number.
std::optional<double> field_number(std::string_view field, char kind, bool is_header) {
  std::string text(trimmed(field));
  const auto letter = text.find_first_of("EeDd");
  if (letter != std::string::npos && letter > 0) {
    text[letter] = 'E';
    if (letter + 1 < text.size() && text[letter + 1] == ' ') text[letter + 1] = '+';
  }
  auto value = number(text);
  const auto sign = text.find_last_of("+-");  // 0.123-103: an exponent that lost its letter
  if (!value && letter == std::string::npos && sign != std::string::npos && sign > 0)
    value = number(text.substr(0, sign) + "E" + text.substr(sign));
  if (!value) return {};
  const bool has_point = text.find('.') != std::string::npos;
  const bool fits = kind == 'I' ? *value == std::floor(*value) : has_point || *value == 0;
  return is_header || fits ? value : std::nullopt;
}

}  // namespace

std::optional<FortranFormat> fortran_format(std::string_view spelling) {
  std::string text;
  for (const char c : spelling)
    if (c != ' ') text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::string_view rest = text;
  if (rest.starts_with('(') && rest.ends_with(')')) rest = rest.substr(1, rest.size() - 2);
  FortranFormat format{.text = std::string(rest)};
  if (rest.size() > 3 && rest.substr(1, 2) == "X,") {
    format.skip = take_count(rest).value_or(0);
    rest.remove_prefix(2);
  }
  if (rest.starts_with("1P")) rest.remove_prefix(rest.starts_with("1P,") ? 3 : 2);
  format.per_line = take_count(rest).value_or(1);
  if (rest.empty() || std::string_view("FEGDI").find(rest[0]) == std::string_view::npos) return {};
  format.kind = rest[0] == 'I' || rest[0] == 'F' ? rest[0] : 'E';
  rest.remove_prefix(1);
  format.width = take_count(rest).value_or(0);
  if (rest.starts_with('.')) {
    rest.remove_prefix(1);
    if (!take_count(rest)) return {};
  }
  const bool sound = rest.empty() && format.per_line > 0 && format.per_line <= kMaxPerLine &&
                     format.width > 0 && format.width <= kWidest;
  return sound ? std::optional(format) : std::nullopt;
}

std::vector<double> FieldReader::read(std::size_t& line, std::size_t count,
                                      const FortranFormat& format, EmptyField empty,
                                      std::string_view what) {
  std::vector<double> values;
  bool all_fit = true;
  for (; values.size() < count; ++line) {
    if (line >= file_.lines().size()) {
      errors_.add(file_.lines().size(), 1,
                  fmt::format("the file ends after {} of {} {}", values.size(), count, what));
      return values;
    }
    const std::size_t expected = std::min(format.per_line, count - values.size());
    FileErrors of_line(file_);
    if (read_fields(line, expected, format, empty, of_line, values)) continue;
    // Only the last field is short, on the last line.
    const std::size_t length = file_.lines()[line].size();
    const std::size_t full = format.skip + expected * format.width;
    const bool is_short = all_fit && length < full && length + format.width > full;
    const bool cut = line + 1 == file_.lines().size() && (!file_.ends_with_line_end() || is_short);
    all_fit = false;
    if (!cut && read_freely(line, expected, values)) continue;
    read_fields(line, expected, format, empty, errors_, values);
    return values;
  }
  return values;
}

bool FieldReader::fits(std::size_t line, std::size_t count, const FortranFormat& format) const {
  FileErrors errors(file_);
  std::vector<double> values;
  return line < file_.lines().size() &&
         read_fields(line, count, format, EmptyField::kError, errors, values);
}

bool FieldReader::read_fields(std::size_t index, std::size_t count, const FortranFormat& format,
                              EmptyField empty, FileErrors& errors,
                              std::vector<double>& values) const {
  const std::string_view line = file_.lines()[index];
  const std::size_t end = format.skip + count * format.width;
  std::vector<double> numbers;
  for (std::size_t begin = format.skip; begin < end; begin += format.width) {
    const auto field = begin < line.size() ? line.substr(begin, format.width) : "";
    if (empty == EmptyField::kZero && trimmed(field).empty()) {
      numbers.push_back(0);
      continue;
    }
    if (empty == EmptyField::kZero && field.find("***") != std::string_view::npos) {
      numbers.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const auto value = field_number(field, format.kind, empty == EmptyField::kZero);
    if (!value || field.size() < format.width) {
      errors.add(index + 1, begin + 1,
                 fmt::format("'{}' is not a number of the format {}", field, format.text));
      return false;
    }
    numbers.push_back(*value);
  }
  if (line.size() > end && !trimmed(line.substr(end)).empty()) {
    errors.add(index + 1, end + 1,
               fmt::format("'{}' follows the {} numbers of this line",
                           trimmed(line.substr(end)).substr(0, 40), count));
    return false;
  }
  append_all(values, numbers);
  return true;
}

bool FieldReader::read_freely(std::size_t index, std::size_t count,
                              std::vector<double>& values) const {
  FileErrors errors(file_);
  NumberReader reader(file_, errors);
  if (reader.read_line(index) != count || errors.any()) return false;
  append_all(values, reader.values());
  return true;
}

double rounding_of(std::string_view printed) {
  const auto point = printed.find('.');
  if (point == printed.npos) return 0.5;
  const auto end = std::min(printed.find_first_not_of("0123456789", point + 1), printed.size());
  return 0.5 * std::pow(10, -static_cast<double>(end - point - 1));
}

std::vector<Eigen::VectorXd> read_table(const SourceFile& file, std::size_t first_line,
                                        const FortranFormat& format, FileErrors& errors) {
  std::size_t end = file.lines().size();
  while (end > first_line && trimmed(file.lines()[end - 1]).empty()) --end;
  const std::size_t columns = format.per_line, rows = end - std::min(first_line, end);
  std::size_t line = first_line;
  const auto values =
      FieldReader(file, errors).read(line, rows * columns, format, EmptyField::kError, "samples");
  if (errors.any()) return {};
  using Row = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Row> table(values.data(), static_cast<Eigen::Index>(rows),
                                    static_cast<Eigen::Index>(columns));
  std::vector<Eigen::VectorXd> result;
  for (Eigen::Index i = 0; i < table.cols(); ++i) result.emplace_back(table.col(i));
  return result;
}

}  // namespace gurney::groundmotions
