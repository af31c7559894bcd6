#include "studies/cli/records_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/base/error.h"
#include "engine/base/printable.h"
#include "groundmotions/formats/writers.h"
#include "studies/cli/signals.h"
#include "studies/results/output_files.h"

namespace gurney::cli {

namespace {
constexpr int kDigits = 9;  ///< after the point [m/s2]
}

std::vector<std::string> record_comments(const groundmotions::Record& record) {
  std::vector<std::string> comments = {"record: " + record.name};
  std::set<std::string> known;
  for (const auto& component : record.components) {
    if (!component) continue;
    if (!component->sha256.empty() && known.insert(component->file).second)
      comments.push_back(fmt::format("from {} ({}, SHA-256 {})",
                                     std::filesystem::path(component->file).filename().string(),
                                     component->format, component->sha256));
    if (component->sha256.empty() && known.insert(component->format).second)
      for (const auto& [name, value] : component->header)
        comments.push_back(fmt::format("{}: {}", name, value));
  }
  for (const std::string& line : record.processing) comments.push_back("processing: " + line);
  for (const std::string& line : record.warnings) comments.push_back("warning: " + line);
  return comments;
}

std::string record_csv(const groundmotions::Record& record) {
  return groundmotions::columns_csv_text(record, record_comments(record), kDigits);
}

std::string file_name(std::string record_name) {
  std::ranges::replace_if(
      record_name, [](char c) { return c == '/' || c == '\\'; }, '_');
  return record_name;
}

void refuse_input_as_output(const std::string& path, const groundmotions::Record& record) {
  std::error_code ignored;
  for (const auto& component : record.components)
    require(!component || !std::filesystem::equivalent(path, component->file, ignored),
            path + ": the record is read from this file; give another name with -o");
}

void write_output(const std::string& path, const std::string& text, bool overwrite, bool quiet) {
  study::OutputFiles files(overwrite);
  files.check(path);
  const SignalsHeld until_written;
  files.stage(path, text);
  files.commit();
  if (!quiet) fmt::print("{}\n", printable(path));
}

}  // namespace gurney::cli
