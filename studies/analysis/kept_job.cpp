#include "studies/analysis/kept_job.h"

#include <filesystem>

namespace gurney::study {

std::string place_of_job(const std::string& job, const std::string& results) {
  if (!job.empty()) return job;
  return (std::filesystem::path(results).parent_path() / "the job of the results.toml").string();
}

}  // namespace gurney::study
