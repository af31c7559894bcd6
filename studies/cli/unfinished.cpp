#include "studies/cli/unfinished.h"

#include <filesystem>

#include "engine/base/files.h"
#include "studies/analysis/kept_job.h"
#include "studies/cli/job_of_log.h"

namespace gurney::cli {

namespace fs = std::filesystem;

std::string results_of_folder(const std::string& folder) {
  const fs::path path = folder, name = path.has_filename() ? path : path.parent_path();
  return (name.parent_path() / name.stem()).string();
}

std::string job_of_folder(const std::string& folder) {
  const fs::path kept = fs::path(folder) / "job";
  if (!is_there(kept)) {
    const std::string results = results_of_folder(folder);
    return study::place_of_job(job_of_log(results), results);
  }
  std::string path = study::file_bytes(kept);
  while (path.ends_with('\n')) path.pop_back();
  return path;
}

}  // namespace gurney::cli
