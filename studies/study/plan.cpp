#include "studies/study/plan.h"

#include <algorithm>

namespace gurney {

Plan::Plan(const StudyJob& job, const StudyMotions& motions) {
  const Study& study = job.study();
  angles_ = study.angles.size();
  draws_ = static_cast<std::size_t>(std::max(1, study.draws));
  runs_of_unit_ = study.intensity.kind == IntensityPlan::Kind::kHunt
                      ? static_cast<std::size_t>(study.intensity.most_runs)
                      : study.intensity.levels.size();
  seed_ = study.seed;
  stated_draws_ = study.draws;
  sampling_ = study.sampling;
  if (stated_draws_ > 0 && sampling_ == Sampling::kSobol) {
    streams_ = std::make_shared<Draw::Streams>();
    for (std::size_t i = 0; i < job.configurations().size(); ++i)
      job.job(i, Draw::noting(seed_, 0, streams_));
  }
  first_.push_back(0);
  for (std::size_t i = 0; i < job.configurations().size(); ++i) {
    const std::size_t records = motions.set_of(i).size();
    most_records_ = std::max<std::uint64_t>(most_records_, records);
    first_.push_back(first_.back() + records * angles_ * draws_);
  }
}

Unit Plan::unit(std::size_t index) const {
  const auto next = std::ranges::upper_bound(first_, index);
  Unit unit;
  unit.configuration = static_cast<std::size_t>(next - first_.begin()) - 1;
  std::size_t rest = index - first_[unit.configuration];
  unit.draw = rest % draws_;
  rest /= draws_;
  unit.angle = rest % angles_;
  unit.record = rest / angles_;
  return unit;
}

std::optional<Draw> Plan::draw(const Unit& unit) const {
  if (stated_draws_ == 0) return {};
  const std::uint64_t number = unit.record * draws_ + unit.draw;
  if (sampling_ == Sampling::kLatinHypercube)
    return Draw::of_hypercube(seed_, number, most_records_ * draws_);
  if (sampling_ == Sampling::kSobol) return Draw::of_sobol(seed_, number, streams_);
  return Draw(seed_, number);
}

}  // namespace gurney
