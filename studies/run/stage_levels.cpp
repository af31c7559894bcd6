#include "studies/run/stage_levels.h"

#include "studies/plan/stages.h"

namespace gurney::study {

StageLevels::StageLevels(const Batch& batch)
    : batch_(batch),
      levels_(batch.job.configurations().size(), batch.job.study().intensity.levels),
      stripes_(levels_.size()) {
  for (std::size_t i = 0; i < levels_.size(); ++i)
    for (const double level : levels_[i]) stripes_[i][level].im = level;
}

void StageLevels::advance(const std::function<TaskResult(std::size_t)>& read) {
  const std::size_t tasks = batch_.plan.tasks_of_stage();
  for (std::size_t index = stage_ * tasks; index < (stage_ + 1) * tasks; ++index) {
    auto& stripes = stripes_[batch_.plan.task(index).configuration];
    for (const StudyRun& run : read(index).runs) {
      if (is_failure(run.response.outcome)) continue;
      statistics::Stripe& stripe = stripes[run.intensity];
      stripe.im = run.intensity;
      stripe.runs += 1;
      stripe.exceeded += run.until;
    }
  }
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    std::vector<statistics::Stripe> made;
    for (const auto& [im, stripe] : stripes_[i]) made.push_back(stripe);
    levels_[i] = next_levels(made, batch_.job.study().intensity.unit_in_si);
  }
  ++stage_;
}

}  // namespace gurney::study
