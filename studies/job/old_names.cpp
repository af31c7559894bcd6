#include "studies/job/old_names.h"

#include <optional>

namespace gurney::study {

std::vector<std::string> rename_old_keys(config::Document& job) {
  std::vector<std::string> notes;
  for (const std::optional<std::string>& note :
       {job.rename_key("study", "certificate", "step_check"),
        job.rename_key("study.intensity", "hunt", "ida"),
        job.rename_text("settings", "solver", "star", "implicit")})
    if (note) notes.push_back(*note);
  return notes;
}

}  // namespace gurney::study
