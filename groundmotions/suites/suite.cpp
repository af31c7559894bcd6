#include "groundmotions/suites/suite.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "groundmotions/suites/folder_suite.h"
#include "groundmotions/suites/list_suite.h"
#include "groundmotions/suites/peer_search_results.h"

namespace gurney {

Suite read_suite(const std::filesystem::path& path, const ReadOptions& options,
                 const Progress& progress) {
  if (std::filesystem::is_directory(path)) return read_folder_suite(path, options, progress);
  const SourceFile file(path);
  if (recognises_peer_search_results(file)) return read_peer_search_results(file, options);
  if (recognises_list_suite(file)) return read_list_suite(file, options);
  Suite suite;
  suite.records.push_back(
      {.name = path.stem().string(), .files = {{.path = path}}, .options = options, .facts = {}});
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
