#include "groundmotions/suites/peer_search_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/base/csv_row.h"
#include "engine/base/error.h"
#include "engine/base/files.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr std::string_view kTable = "Summary of Metadata of Selected Records";
constexpr std::array kFiles = {"Horizontal-1 Acc. Filename", "Horizontal-2 Acc. Filename",
                               "Vertical Acc. Filename"};

/// Columns that become facts, by the start of their titles.
constexpr std::array kFacts = {
    std::pair("Record Sequence Number", "RSN"),
    std::pair("Earthquake Name", "event"),
    std::pair("Year", "year"),
    std::pair("Station Name", "station"),
    std::pair("Magnitude", "magnitude"),
    std::pair("Mechanism", "mechanism"),
    std::pair("Rjb", "R_JB [km]"),
    std::pair("Rrup", "R_rup [km]"),
    std::pair("Vs30", "Vs30 [m/s]"),
    std::pair("Tp-Pulse Period", "pulse period [s]"),
    std::pair("Lowest Useable Frequency", "lowest usable frequency [Hz]"),
    std::pair("Scale Factor", "scale factor of the search"),
};

std::size_t column_of(const std::vector<CsvCell>& titles, std::string_view start) {
  for (std::size_t i = 0; i < titles.size(); ++i)
    if (titles[i].text.starts_with(start)) return i;
  return kNone;
}

std::string cell(const std::vector<CsvCell>& row, std::size_t column) {
  if (column >= row.size()) return {};
  const bool dashes = row[column].text.find_first_not_of('-') == std::string::npos;
  if (dashes) return {};
  return row[column].text;
}

/// The line with the titles of the table.
std::size_t title_line(const SourceFile& file) {
  const auto& lines = file.lines();
  for (std::size_t i = 0; i + 1 < lines.size(); ++i)
    if (lines[i].find(kTable) != std::string_view::npos) return i + 1;
  throw Error(fmt::format("{}:1:1: no table '{}'", file.name(), kTable));
}

struct Columns {
  std::size_t count = 0;
  std::size_t number = kNone;
  std::array<std::size_t, 3> files;
  std::vector<std::pair<const char*, std::size_t>> facts;
};

Columns columns_of(const SourceFile& file, std::size_t line) {
  const auto titles = csv_row(file.lines()[line]);
  Columns columns;
  columns.count = titles.size();
  columns.number = column_of(titles, "Record Sequence Number");
  for (std::size_t i = 0; i < 3; ++i) {
    columns.files[i] = column_of(titles, kFiles[i]);
    require(columns.files[i] != kNone, fmt::format("{}:{}:1: no column '{}'", file.name(),
                                                   line + 1 + file.blank_lines(), kFiles[i]));
  }
  for (const auto& [start, name] : kFacts)
    if (const auto column = column_of(titles, start); column != kNone)
      columns.facts.emplace_back(name, column);
  return columns;
}

/// Why a record cannot be used.
struct Lack {
  std::string reason;      ///< empty: nothing lacks
  bool is_absent = false;  ///< none of its files is there
};

Lack add_files(const std::vector<CsvCell>& row, const Columns& columns,
               const std::filesystem::path& folder, SuiteRecord& record) {
  std::string reason;
  std::size_t absent = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name = cell(row, columns.files[i]);
    if (name.empty()) {
      if (i < 2) reason = fmt::format("the report names no file for '{}'", kFiles[i]);
      continue;
    }
    const auto path = folder / name;
    if (!is_file(path)) {
      reason += fmt::format("{}{} is not in the folder", reason.empty() ? "" : "; ", name);
      ++absent;
    }
    record.files.push_back({.path = path});
  }
  return {reason, absent > 0 && absent == record.files.size()};
}

/// One note for all records that are not there; a refusal if that leaves none.
void report_absent(const SourceFile& file, const std::vector<std::string>& absent, Suite& suite) {
  constexpr std::size_t kShown = 3;
  if (absent.empty()) return;
  const std::size_t all = absent.size() + suite.records.size() + suite.refused.size();
  const std::vector<std::string> first(
      absent.begin(),
      absent.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, absent.size())));
  const std::string text = fmt::format(
      "{}: the files of {} of its {} records are not in the folder: {}{}", file.name(),
      absent.size(), all, fmt::join(first, ", "),
      absent.size() > kShown ? fmt::format(" and {} more", absent.size() - kShown) : "");
  if (absent.size() == all)
    suite.refused.push_back({file.name(), text});
  else
    suite.notes.push_back(text);
}

}  // namespace

bool recognises_peer_search_results(const SourceFile& file) {
  const auto& lines = file.lines();
  return std::any_of(
      lines.begin(),
      lines.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(60, lines.size())),
      [](std::string_view line) { return line.find(kTable) != std::string_view::npos; });
}

Suite read_peer_search_results(const SourceFile& file, const ReadOptions& options) {
  const std::size_t titles = title_line(file);
  const Columns columns = columns_of(file, titles);
  const auto folder = std::filesystem::path(file.name()).parent_path();
  Suite suite;
  std::vector<std::string> absent;
  for (std::size_t line = titles + 1; line < file.lines().size(); ++line) {
    const auto row = csv_row(file.lines()[line]);
    if (row.size() == 1) break;  // a blank line ends the table
    SuiteRecord record{.name = {}, .files = {}, .options = options, .facts = {}};
    for (const auto& [name, column] : columns.facts)
      if (const std::string text = cell(row, column); !text.empty())
        record.facts.emplace_back(name, text);
    const std::string number = cell(row, columns.number);
    record.name =
        number.empty() ? fmt::format("line {}", line + 1 + file.blank_lines()) : "RSN" + number;
    const Lack lack =
        row.size() == columns.count
            ? add_files(row, columns, folder, record)
            : Lack{fmt::format("{}:{}:1: {} cells, the header has {} columns", file.name(),
                               line + 1 + file.blank_lines(), row.size(), columns.count)};
    if (lack.is_absent)
      absent.push_back(record.name);
    else if (lack.reason.empty())
      suite.records.push_back(std::move(record));
    else
      suite.refused.push_back({record.name, lack.reason});
  }
  report_absent(file, absent, suite);
  require(!suite.records.empty() || !suite.refused.empty(),
          fmt::format("{}:{}:1: the table '{}' has no rows", file.name(),
                      titles + 1 + file.blank_lines(), kTable));
  return suite;
}

}  // namespace gurney::groundmotions
