#include "studies/cli/study_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace gurney::cli {

std::string list_of(const std::vector<std::string>& all) {
  constexpr std::size_t kShown = 6;
  const std::vector<std::string> shown(
      all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, all.size())));
  return fmt::format("{}: {}{}", all.size(), fmt::join(shown, "; "),
                     all.size() > kShown ? "; ..." : "");
}

std::vector<std::string> job_warnings(const study::StudyJob& job) {
  std::vector<std::string> order = job.notes();
  std::map<std::string, std::vector<std::string>> of;
  for (std::size_t i = 0; i < job.configurations().size(); ++i)
    for (const std::string& warning : job.job(i, {}).warnings) {
      if (!of.contains(warning)) order.push_back(warning);
      of[warning].push_back(fmt::format("{}", fmt::join(job.configurations()[i].levels, ", ")));
    }
  for (std::string& warning : order)
    if (const auto& found = of[warning];
        !found.empty() && found.size() < job.configurations().size())
      warning += " (" + list_of(found) + ")";
  return order;
}

}  // namespace gurney::cli
