#include "studies/exports/export.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

#include "engine/base/printable.h"

namespace gurney::study {

std::string plain_identifier(const std::string& text, const std::string& otherwise) {
  std::string plain;
  bool any = false;
  for (const char c : text) {
    const bool keep = std::isalnum(static_cast<unsigned char>(c)) != 0;
    any = any || keep;
    if (keep || plain.empty() || plain.back() != '_') plain += keep ? c : '_';
  }
  return any ? plain : otherwise;
}

namespace {

bool is_number(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [stop, failed] = std::from_chars(begin, end, value);
  return failed == std::errc() && stop == end;
}

/// A spreadsheet computes a cell that begins so; an apostrophe makes it text.
bool is_formula(const std::string& text) {
  return !text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos &&
         !is_number(text);
}

std::string quoted_where_needed(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string csv_cell(const std::string& text) {
  const std::string plain = printable(text);
  return quoted_where_needed(is_formula(plain) ? "'" + plain : plain);
}

std::string csv_cell(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

std::string csv_line(const std::vector<std::string>& cells) {
  return fmt::format("{}\n", fmt::join(cells, ","));
}

}  // namespace gurney::study
