#include "studies/calibration/trials/csv_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "engine/base/csv_row.h"
#include "engine/base/error.h"
#include "engine/base/input_file.h"
#include "engine/base/printable.h"

namespace gurney::calibration {
namespace {

constexpr std::size_t kMaxErrors = 20;
constexpr int kMostControls = 3;  // lines with control characters
constexpr const char* kBlanks = " \t\r";

TextCell trimmed(const std::string& line, std::size_t from, std::size_t to, int number) {
  std::size_t first = line.find_first_not_of(kBlanks, from);
  if (first == std::string::npos || first >= to) first = to;
  std::size_t last = to;
  while (last > first && std::string(kBlanks).find(line[last - 1]) != std::string::npos) --last;
  return {line.substr(first, last - first), number, static_cast<int>(first) + 1};
}

/// Cells of one line, without empty ones at its end.
std::vector<TextCell> cells_of(std::string_view line, int number) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::vector<TextCell> cells;
  for (CsvCell& cell : csv_row(line))
    cells.push_back({std::move(cell.text), number, static_cast<int>(cell.column)});
  while (!cells.empty() && cells.back().text.empty()) cells.pop_back();
  return cells;
}

void read_fact(std::string line, int number, CsvText& text, CsvErrors& errors) {
  while (!line.empty() && std::string(", \t\r").find(line.back()) != std::string::npos)
    line.pop_back();
  std::size_t begin = line.find('#') + 1;
  if (line.front() == '"') {  // a spreadsheet quotes a cell with a comma
    if (line.back() == '"') line.pop_back();
  }
  const std::size_t equals = line.find('=', begin);
  if (equals == std::string::npos) {
    errors.note(number, static_cast<int>(begin),
                "a line with # must be `# key = value`; free text is `# note = ...`");
    return;
  }
  CsvFact fact{trimmed(line, begin, equals, number),
               trimmed(line, equals + 1, line.size(), number)};
  if (fact.key.text != "note" && std::ranges::any_of(text.facts, [&](const CsvFact& f) {
        return f.key.text == fact.key.text;
      }))
    errors.note(fact.key, fact.key.text + ": stands here twice");
  text.facts.push_back(std::move(fact));
}

void read_row(std::vector<TextCell> cells, const std::string& line, int number, CsvText& text,
              CsvErrors& errors) {
  const std::size_t size = text.header.size();
  if (cells.size() > size) {
    errors.note(cells[size], fmt::format("{} cells, but {} columns", cells.size(), size));
    return;
  }
  while (cells.size() < size) {
    if (static_cast<std::size_t>(std::ranges::count(line, ',')) + 1 < size) {
      errors.note(number, 1, fmt::format("{} cells, but {} columns", cells.size(), size));
      return;
    }
    cells.push_back({"", number, static_cast<int>(line.size()) + 1});
  }
  text.rows.push_back(std::move(cells));
}

/// @returns whether there is one
bool note_control_character(std::string_view line, int number, CsvErrors& errors) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  const auto at = find_control_character(line);
  if (at != line.npos)
    errors.note(number, static_cast<int>(at) + 1, "a control character; must be text");
  return at != line.npos;
}

}  // namespace

void CsvErrors::note(const TextCell& at, const std::string& message) {
  note(at.line, at.column, message);
}

void CsvErrors::note(int line, int column, const std::string& message) {
  errors_.add(line, column, fmt::format("{}:{}:{}: {}", file_, line, column, message));
}

void CsvErrors::finish() const {
  Diagnostics errors = errors_;
  errors.sort();
  errors.raise(kMaxErrors, file_ + ": and ", " more errors");
}

CsvText read_csv_text(const std::string& file, CsvErrors& errors) {
  std::string all = read_input_file(file);
  if (all.starts_with("\xEF\xBB\xBF")) all.erase(0, 3);
  CsvText text{file, {}, {}, {}};
  int number = 0, controls = 0;
  for (std::size_t from = 0; from < all.size();) {
    const std::size_t to = std::min(all.find('\n', from), all.size());
    const std::string line = all.substr(from, to - from);
    from = to + 1;
    ++number;
    if (note_control_character(line, number, errors)) {
      if (++controls == kMostControls) errors.finish();  // it is no text file
      continue;
    }
    std::vector<TextCell> cells = cells_of(line, number);
    if (cells.empty()) continue;
    if (cells[0].text.starts_with('#')) {
      if (text.header.empty())
        read_fact(line, number, text, errors);
      else
        errors.note(cells[0], "lines with # stand above the names of the columns");
    } else if (text.header.empty()) {
      text.header = std::move(cells);
    } else {
      read_row(std::move(cells), line, number, text, errors);
    }
  }
  require(!text.header.empty(), file + ": has no row with the names of the columns");
  return text;
}

}  // namespace gurney::calibration
