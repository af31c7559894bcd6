#include "groundmotions/suites/list_suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "engine/base/csv_row.h"
#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/number_text.h"
#include "engine/config/nearest_name.h"
#include "engine/config/range.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/formats/words.h"
#include "groundmotions/record/acceleration_unit.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {
namespace {

const std::vector<std::string> kColumns = {"name",    "file",           "channels", "h1",
                                           "h2",      "vertical",       "unit",     "time_step_s",
                                           "columns", "count_m_per_s2", "scale"};

using config::Range;

const Range kFactors = Range::within(0, 1e6).open_below();

bool is_content(std::string_view line) {
  line = trimmed(line);
  return !line.empty() && line[0] != '#';
}

class ListReader {
 public:
  ListReader(const SourceFile& file, const ReadOptions& options)
      : file_(file), options_(options), errors_(file) {}

  Suite read() {
    bool first = true;
    for (line_ = 0; line_ < file_.lines().size(); ++line_) {
      if (!is_content(file_.lines()[line_])) continue;
      if (std::exchange(first, false))
        read_titles();
      else
        read_row();
    }
    if (suite_.records.empty()) errors_.add("the list has no records");
    errors_.throw_if_any();
    return std::move(suite_);
  }

 private:
  void read_titles() {
    for (const CsvCell& cell : csv_row(file_.lines()[line_])) {
      if (std::ranges::find(kColumns, cell.text) == kColumns.end())
        errors_.add(line_ + 1, cell.column,
                    fmt::format("unknown column '{}'{}", cell.text,
                                config::suggestion(cell.text, kColumns)));
      if (std::ranges::find(titles_, cell.text) != titles_.end())
        errors_.add(line_ + 1, cell.column, fmt::format("column '{}' comes twice", cell.text));
      titles_.push_back(cell.text);
    }
    const auto has = [this](const char* title) {
      return std::ranges::find(titles_, title) != titles_.end();
    };
    if (has("file") || has("h1") || has("h2") || has("vertical")) return;
    errors_.add(line_ + 1, 1, "a list needs a column 'file', or columns 'h1', 'h2', 'vertical'");
    errors_.throw_if_any();  // no row can have one
  }

  void read_row() {
    const auto row = csv_row(file_.lines()[line_]);
    if (row.size() != titles_.size()) {
      errors_.add(line_ + 1, 1,
                  fmt::format("{} cells, the header has {} columns", row.size(), titles_.size()));
      return;
    }
    SuiteRecord record{.name = {}, .files = {}, .options = options_, .facts = {}};
    for (std::size_t i = 0; i < row.size(); ++i) read_cell(titles_[i], row[i], record);
    if (record.files.empty()) errors_.add(line_ + 1, 1, "the record has no file");
    take_channels(row, record);
    const auto stated = std::ranges::count_if(
        record.files, [](const RecordFile& file) { return file.direction.has_value(); });
    if (stated != 0 && stated != std::ssize(record.files))
      errors_.add(line_ + 1, 1,
                  "a record has files in 'file' or in 'h1', 'h2', 'vertical', not in both");
    suite_.records.push_back(std::move(record));
  }

  void read_cell(const std::string& title, const CsvCell& cell, SuiteRecord& record) {
    if (title == "name") {
      const bool known = std::ranges::any_of(
          suite_.records, [&](const SuiteRecord& other) { return other.name == cell.text; });
      if (cell.text.empty() || known)
        errors_.add(line_ + 1, cell.column,
                    cell.text.empty() ? "a record needs a name"
                                      : fmt::format("the name '{}' comes twice", cell.text));
      record.name = cell.text;
    } else if (cell.text.empty()) {
      return;
    } else if (title == "unit") {
      if (!acceleration_unit(cell.text))
        errors_.add(line_ + 1, cell.column,
                    fmt::format("'{}' is not a unit of acceleration: {} are allowed", cell.text,
                                kAccelerationUnits));
      record.options.unit = cell.text;
    } else if (title == "time_step_s") {
      record.options.time_step =
          within(cell, title, Range::within(kShortestTimeStep, kLongestTimeStep));
    } else if (title == "columns") {
      record.options.columns = cell.text;
    } else if (title == "count_m_per_s2") {
      record.options.si_per_count = within(cell, title, kFactors);
    } else if (title == "scale") {
      record.scale = within(cell, title, kFactors);
    } else if (title != "channels" && std::ranges::find(kColumns, title) != kColumns.end()) {
      add_file(title, cell, record);
    }
  }

  /// One file and some of its channels: each becomes a file of the record.
  void take_channels(const std::vector<CsvCell>& row, SuiteRecord& record) {
    const auto title = std::ranges::find(titles_, "channels");
    if (title == titles_.end()) return;
    const CsvCell& cell = row[static_cast<std::size_t>(title - titles_.begin())];
    if (cell.text.empty()) return;
    if (record.files.size() != 1 || record.files[0].direction) {
      errors_.add(line_ + 1, cell.column, "channels must go with one file in 'file'");
      return;
    }
    const RecordFile file = record.files[0];
    record.files.clear();
    std::istringstream texts(cell.text);
    for (std::string text; std::getline(texts, text, ';');) {
      const auto channel = number(text);
      if (!channel || !(*channel >= 1 && *channel <= 1000 && *channel == std::floor(*channel)))
        errors_.add(
            line_ + 1, cell.column,
            fmt::format("channels must be whole numbers from 1 to 1000 apart by semicolons, "
                        "got '{}'",
                        text));
      else
        record.files.push_back({.path = file.path, .channel = static_cast<int>(*channel)});
    }
  }

  /// The column 'file' may hold several, apart by semicolons.
  void add_file(const std::string& title, const CsvCell& cell, SuiteRecord& record) {
    std::error_code ignored;
    std::istringstream names(cell.text);
    for (std::string name; std::getline(names, name, ';');) {
      const std::string plain(trimmed(name));
      RecordFile file{.path = std::filesystem::path(file_.name()).parent_path() / plain};
      for (const Direction direction : kDirections)
        if (title == name_of(direction)) file.direction = direction;
      if (!is_file(file.path))
        errors_.add(line_ + 1, cell.column,
                    fmt::format("'{}': {}", plain,
                                std::filesystem::is_directory(file.path, ignored)
                                    ? "is a folder, a file is needed"
                                    : "no such file"));
      record.files.push_back(std::move(file));
    }
  }

  double within(const CsvCell& cell, const std::string& title, const Range& range) {
    const auto value = number(cell.text);
    if (!value || !range.contains(*value))
      errors_.add(line_ + 1, cell.column,
                  fmt::format("{} '{}': must be {}", title, cell.text, range.text()));
    return value.value_or(1);
  }

  const SourceFile& file_;
  const ReadOptions& options_;
  FileErrors errors_;
  std::vector<std::string> titles_;
  std::size_t line_ = 0;
  Suite suite_;
};

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
struct Unusable {
  std::string reason;      ///< empty: nothing lacks
  bool is_absent = false;  ///< none of its files is there
};

Unusable add_files(const std::vector<CsvCell>& row, const Columns& columns,
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

bool recognises_list_suite(const SourceFile& file) {
  for (const std::string_view line : file.lines())
    if (is_content(line)) return csv_row(line).size() > 1 && csv_row(line)[0].text == "name";
  return false;
}

Suite read_list_suite(const SourceFile& file, const ReadOptions& options) {
  return ListReader(file, options).read();
}

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
    const Unusable problem =
        row.size() == columns.count
            ? add_files(row, columns, folder, record)
            : Unusable{fmt::format("{}:{}:1: {} cells, the header has {} columns", file.name(),
                                   line + 1 + file.blank_lines(), row.size(), columns.count)};
    if (problem.is_absent)
      absent.push_back(record.name);
    else if (problem.reason.empty())
      suite.records.push_back(std::move(record));
    else
      suite.refused.push_back({record.name, problem.reason});
  }
  report_absent(file, absent, suite);
  require(!suite.records.empty() || !suite.refused.empty(),
          fmt::format("{}:{}:1: the table '{}' has no rows", file.name(),
                      titles + 1 + file.blank_lines(), kTable));
  return suite;
}

}  // namespace gurney::groundmotions
