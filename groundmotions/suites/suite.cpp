#include "groundmotions/suites/suite.h"

#include <fmt/format.h>
#include <glob.h>

#include <iterator>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/config/file_snapshot.h"
#include "groundmotions/suites/folder_suite.h"
#include "groundmotions/suites/list_suite.h"

namespace gurney::groundmotions {
namespace {

void append(Suite& suite, Suite more) {
  std::ranges::move(more.records, std::back_inserter(suite.records));
  std::ranges::move(more.refused, std::back_inserter(suite.refused));
  std::ranges::move(more.notes, std::back_inserter(suite.notes));
  std::ranges::move(more.warnings, std::back_inserter(suite.warnings));
}

/// A folder, list or report; false for anything else.
bool append_collection(const std::filesystem::path& path, const ReadOptions& options,
                       const Progress& progress, Suite& suite) {
  if (is_folder(path)) {
    append(suite, read_folder_suite(path, options, progress));
    return true;
  }
  require(is_there(path), path.string() + ": no such file or folder");
  std::optional<SourceFile> file;
  try {
    file.emplace(path);
  } catch (const Error&) {
    return false;  // reported when it is read as a record
  }
  if (!file->is_text()) return false;
  if (recognises_peer_search_results(*file))
    append(suite, read_peer_search_results(*file, options));
  else if (recognises_list_suite(*file))
    append(suite, read_list_suite(*file, options));
  else
    return false;
  config::FileSnapshot::note(path.string(), std::string(file->bytes()));
  return true;
}

std::vector<std::filesystem::path> expanded(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::filesystem::path> all;
  for (const auto& path : paths) {
    if (!is_glob(path)) {
      all.push_back(path);
      continue;
    }
    const auto found = glob(path);
    require(!found.empty(), path.string() + ": no file or folder has a name of this pattern");
    append_all(all, found);
  }
  return all;
}

}  // namespace

std::string text_of(const Refusal& refusal) {
  return refusal.reason.find(refusal.file + ":") == std::string::npos
             ? refusal.file + ": " + refusal.reason
             : refusal.reason;
}

Suite read_suite(const std::vector<std::filesystem::path>& paths, const ReadOptions& options,
                 const Progress& progress) {
  Suite suite;
  std::vector<std::filesystem::path> files;
  for (const auto& path : expanded(paths))
    if (!append_collection(path, options, progress, suite)) files.push_back(path);
  if (!files.empty()) append(suite, group_files(files, options, progress));
  return suite;
}

Record read_record(const SuiteRecord& entry) {
  Record record = read_record(entry.files, entry.options);
  record.name = entry.name;
  if (entry.scale == 1) return record;
  for (auto& component : record.components)
    if (component) component->acceleration *= entry.scale;
  record.processing.push_back(fmt::format("scaled by {:g}, as the list says", entry.scale));
  return record;
}

bool is_glob(const std::filesystem::path& path) {
  std::error_code ignored;
  return path.string().find_first_of("*?[") != std::string::npos &&
         !std::filesystem::exists(path, ignored);
}

std::vector<std::filesystem::path> glob(const std::filesystem::path& pattern) {
  std::vector<std::filesystem::path> paths;
  glob_t found{};
  if (::glob(pattern.c_str(), 0, nullptr, &found) == 0)
    for (std::size_t i = 0; i < found.gl_pathc; ++i) paths.emplace_back(found.gl_pathv[i]);
  ::globfree(&found);
  return paths;
}

}  // namespace gurney::groundmotions
