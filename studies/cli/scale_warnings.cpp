#include "studies/cli/scale_warnings.h"

#include <algorithm>

#include "groundmotions/scaling/scale.h"

namespace gurney::cli {

std::vector<std::string> scale_warnings(const study::Batch& batch) {
  const study::IntensityPlan& plan = batch.job.study().intensity;
  const double highest = plan.kind == study::IntensityPlan::Kind::kIda || plan.levels.empty()
                             ? plan.first
                             : *std::ranges::max_element(plan.levels);
  std::vector<std::string> warnings;
  for (std::size_t set = 0; set < batch.motions.sets(); ++set) {
    const study::MotionSet& motions = batch.motions.set(set);
    for (std::size_t i = 0; i < motions.size(); ++i) {
      if (motions.name(i).empty()) continue;
      const bool is_factor = plan.kind == study::IntensityPlan::Kind::kScales;
      const std::string warning =
          groundmotions::dubious_factor(is_factor ? highest : motions.scale_for(i, highest));
      if (!warning.empty()) warnings.push_back(motions.name(i) + ": " + warning);
    }
  }
  return warnings;
}

}  // namespace gurney::cli
