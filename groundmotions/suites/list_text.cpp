#include <fmt/format.h>

#include <array>
#include <optional>
#include <set>

#include "groundmotions/suites/list_suite.h"

namespace gurney::groundmotions {
namespace {

/// A cell in quotes, a quote in it doubled (RFC 4180).
std::string csv_cell(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + "\"";
}

/// The channels of a record whose files are channels of one.
std::string channels_text(const std::vector<RecordFile>& files) {
  std::string text;
  for (const RecordFile& file : files)
    if (file.channel) text += fmt::format("{}{}", text.empty() ? "" : ";", *file.channel);
  return text;
}

/// The cells file, h1, h2, vertical and channels of a list.
std::string files_text(const std::vector<RecordFile>& files, const std::filesystem::path& folder) {
  std::array<std::string, 5> cells;
  cells[4] = channels_text(files);
  for (const RecordFile& file : files) {
    if (file.channel && &file != &files[0]) continue;
    std::string& cell = cells[file.direction ? 1 + static_cast<std::size_t>(*file.direction) : 0];
    cell += (cell.empty() ? "" : ";") + std::filesystem::proximate(file.path, folder).string();
  }
  for (std::string& cell : cells)
    if (!cell.empty()) cell = csv_cell(cell);
  return fmt::format("{}", fmt::join(cells, ","));
}

std::string shown(const std::optional<double>& value) {
  return value ? fmt::format("{:g}", *value) : std::string();
}

}  // namespace

std::string list_suite_text(const std::vector<SuiteRecord>& records,
                            const std::filesystem::path& folder, const std::string& comment) {
  std::string text = fmt::format(
      "# {}\n"
      "name,file,h1,h2,vertical,channels,unit,time_step_s,columns,count_m_per_s2,scale\n",
      comment);
  std::set<std::string> names;
  for (const SuiteRecord& record : records) {
    std::string name = record.name;
    for (int n = 2; !names.insert(name).second; ++n) name = fmt::format("{} ({})", record.name, n);
    const ReadOptions& read = record.options;
    text += fmt::format("{},{},{},{},\"{}\",{},{:.6g}\n", csv_cell(name),
                        files_text(record.files, folder), read.unit, shown(read.time_step),
                        read.columns, shown(read.si_per_count), record.scale);
  }
  return text;
}

}  // namespace gurney::groundmotions
