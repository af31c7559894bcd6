#include "engine/base/csv_row.h"

#include "engine/base/number_text.h"

namespace gurney {

namespace {

/// The quoted text at the start of `rest`, which is shortened by it.
std::string take_quoted(std::string_view& rest) {
  std::string text;
  for (rest.remove_prefix(1); !rest.empty(); rest.remove_prefix(1)) {
    if (rest[0] == '"') {
      if (rest.size() < 2 || rest[1] != '"') {
        rest.remove_prefix(1);
        break;
      }
      rest.remove_prefix(1);
    }
    text += rest[0];
  }
  return text;
}

}  // namespace

std::vector<CsvCell> csv_row(std::string_view line) {
  std::vector<CsvCell> cells;
  std::string_view rest = line;
  for (;;) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    CsvCell cell{.text = {}, .column = line.size() - rest.size() + 1};
    if (!rest.empty() && rest[0] == '"') cell.text = take_quoted(rest);
    const auto comma = std::min(rest.find(','), rest.size());
    cell.text += trimmed(rest.substr(0, comma));
    cells.push_back(std::move(cell));
    if (comma == rest.size()) return cells;
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace gurney
