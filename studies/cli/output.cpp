#include "studies/cli/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "engine/base/error.h"
#include "engine/base/printable.h"
#include "groundmotions/formats/writers.h"
#include "studies/cli/commands.h"
#include "studies/cli/process.h"
#include "studies/results/output_files.h"

namespace gurney::cli {

namespace fs = std::filesystem;

bool names_a_file(const fs::path& output) {
  std::error_code ignored;
  std::string ending = output.extension().string();
  if (ending.size() < 2 || fs::is_directory(output, ignored)) return false;
  ending.erase(0, 1);
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return ending == "h5" || ending == "AT2" || std::ranges::all_of(ending, is_letter);
}

void require_name_of_folder(const fs::path& output) {
  std::error_code ignored;
  require(!fs::exists(output, ignored) || fs::is_directory(output, ignored),
          output.string() + ": is a file, the name of a folder is needed (-o FOLDER)");
  require(!names_a_file(output),
          fmt::format("{}: is named like a file, but several are written: name a folder (-o {})",
                      output.string(), fs::path(output).replace_extension().string()));
}

NewFolder::NewFolder(const fs::path& path)
    : path_(path.has_filename() ? path : path.parent_path()) {
  std::error_code error;
  const fs::path parent = path_.has_parent_path() ? path_.parent_path() : ".";
  require(fs::is_directory(parent, error),
          fmt::format("{}: cannot be written: the folder {} does not exist", path_.string(),
                      parent.string()));
  require_name_of_folder(path_);
  made_ = fs::create_directory(path_, error);
  require(!error, path_.string() + ": cannot be written: " + error.message());
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (made_) fs::remove(path_, ignored);  // only if it is empty
}

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
  groundmotions::require_readable(record);
  return groundmotions::columns_csv_text(record, record_comments(record), kDigits);
}

std::string file_name(std::string record_name) {
  std::ranges::replace_if(
      record_name, [](char c) { return c == '/' || c == '\\'; }, '_');
  return record_name;
}

void check_csv_output(const std::string& path, bool overwrite) {
  require_usage(fs::path(path).extension() == ".csv", path + ": must be a file that ends in .csv");
  study::OutputFiles(overwrite).check(path);
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
