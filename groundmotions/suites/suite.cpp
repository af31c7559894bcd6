#include "groundmotions/suites/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "engine/base/config/file_snapshot.h"
#include "engine/base/error.h"
#include "groundmotions/suites/folder_suite.h"
#include "groundmotions/suites/list_suite.h"
#include "groundmotions/suites/peer_search_results.h"

namespace gurney {

namespace {

void append(Suite& suite, Suite more) {
  std::ranges::move(more.records, std::back_inserter(suite.records));
  std::ranges::move(more.refused, std::back_inserter(suite.refused));
}

/// A folder, list or report; false for anything else.
bool append_collection(const std::filesystem::path& path, const ReadOptions& options,
                       const Progress& progress, Suite& suite) {
  if (std::filesystem::is_directory(path)) {
    append(suite, read_folder_suite(path, options, progress));
    return true;
  }
  require(std::filesystem::exists(path), path.string() + ": no such file or folder");
  std::optional<SourceFile> file;
  try {
    file.emplace(path);
  } catch (const Error&) {
    return false;  // told when it is read as a record
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

}  // namespace

Suite read_suite(const std::vector<std::filesystem::path>& paths, const ReadOptions& options,
                 const Progress& progress) {
  Suite suite;
  std::vector<std::filesystem::path> files;
  for (const auto& path : paths)
    if (!append_collection(path, options, progress, suite)) files.push_back(path);
  append(suite, group_files(files, options, progress));
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

}  // namespace gurney
