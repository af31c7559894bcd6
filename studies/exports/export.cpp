#include "studies/exports/export.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

namespace gurney {

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

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csv_cell(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

std::string csv_line(const std::vector<std::string>& cells) {
  return fmt::format("{}\n", fmt::join(cells, ","));
}

}  // namespace gurney
