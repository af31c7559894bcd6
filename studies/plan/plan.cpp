#include "studies/plan/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "engine/base/error.h"
#include "engine/base/random/normal_draw.h"
#include "studies/plan/stages.h"

namespace gurney::study {
namespace {

constexpr const char* kRecord = "record";

}  // namespace

Plan::Plan(const StudyJob& job, const StudyMotions& motions) {
  const Study& study = job.study();
  stages_ = 1 + static_cast<std::size_t>(study.intensity.more_stages);
  angles_ = study.angles.size();
  draws_ = static_cast<std::size_t>(std::max(1, study.draws));
  replicas_ = static_cast<std::size_t>(study.replicas);
  runs_of_task_ = study.intensity.kind == IntensityPlan::Kind::kIda
                      ? static_cast<std::size_t>(study.intensity.most_runs)
                      : motions.set_of(0).levels(0).size();
  seed_ = study.seed;
  stated_draws_ = study.draws;
  sampling_ = study.sampling;
  for (std::size_t i = 0; i < job.configurations().size(); ++i) {
    const MotionSet& set = motions.set_of(i);
    most_records_ = std::max<std::uint64_t>(most_records_, set.size());
    if (set.levels(0).size() != motions.set_of(0).levels(0).size())
      throw Error(job.job(i, std::nullopt).record->where +
                  ": excitation.record.suite_by_level: must be of all configurations or of none");
  }
  if (stated_draws_ > 0 && (sampling_ == Sampling::kSobol || sampling_ == Sampling::kSaltelli)) {
    streams_ = std::make_shared<Draw::Streams>();
    for (std::size_t i = 0; i < job.configurations().size(); ++i)
      for (const equipment::Assumption& each : job.job(i, Draw(seed_, 0)).assumptions)
        streams_->insert(each.streams.begin(), each.streams.end());
  }
  if (sampling_ == Sampling::kSaltelli) {
    require(!streams_->empty(),
            job.file() +
                ": study.sampling = \"saltelli\" needs a parameter that is drawn; "
                "none has a distribution");
    if (most_records_ > 1)
      record_input_ = std::distance(streams_->begin(), streams_->insert(kRecord).first);
    require(2 * streams_->size() <= kSobolDimensions,
            fmt::format("{}: study.sampling = \"saltelli\": {} inputs are too many, at most {}",
                        job.file(), streams_->size(), kSobolDimensions / 2));
    draws_ *= kSaltelliMatrices + streams_->size();
  }
  refuse_uncountable(job.file(), static_cast<double>(most_records_) *
                                     static_cast<double>(job.configurations().size()));
  first_.push_back(0);
  for (std::size_t i = 0; i < job.configurations().size(); ++i)
    first_.push_back(first_.back() + motions.set_of(i).size() * angles_ * draws_ * replicas_);
}

void Plan::refuse_uncountable(const std::string& job, double motions) const {
  constexpr double kMax = 1e15;  // so that indices and counts of runs fit into their integers
  const double of_unit =
      static_cast<double>(runs_of_task_) + static_cast<double>((stages_ - 1) * kLevelsOfAStage);
  const double runs = motions * static_cast<double>(angles_) * static_cast<double>(draws_) *
                      static_cast<double>(replicas_) * of_unit;
  require(runs < kMax, fmt::format("{}: the study has about {:.2g} runs: too many", job, runs));
}

std::size_t Plan::runs() const {
  return tasks_of_stage() * (runs_of_task_ + (stages_ - 1) * kLevelsOfAStage);
}

Task Plan::task(std::size_t index) const {
  const std::size_t stage = index / tasks_of_stage();
  index %= tasks_of_stage();
  const auto next = std::ranges::upper_bound(first_, index);
  Task task;
  task.stage = stage;
  task.configuration = static_cast<std::size_t>(next - first_.begin()) - 1;
  std::size_t rest = index - first_[task.configuration];
  task.replica = rest % replicas_;
  rest /= replicas_;
  task.draw = rest % draws_;
  rest /= draws_;
  task.angle = rest % angles_;
  task.record = rest / angles_;
  task.draw += task.record * draws_;
  if (const auto row = row_of(task.draw); row && record_input_ && row->from_b(*record_input_))
    task.record = record_in_b(task.configuration, row->point);
  return task;
}

std::size_t Plan::draws(std::size_t configuration) const {
  return (first_.at(configuration + 1) - first_[configuration]) / angles_ / replicas_;
}

std::vector<std::string> Plan::inputs() const {
  if (sampling_ != Sampling::kSaltelli) return {};
  return {streams_->begin(), streams_->end()};
}

std::optional<SaltelliRow> Plan::row_of(std::size_t draw) const {
  if (sampling_ != Sampling::kSaltelli) return {};
  const std::size_t matrices = kSaltelliMatrices + streams_->size();
  return SaltelliRow{draw / matrices, draw % matrices};
}

std::size_t Plan::record_in_b(std::size_t configuration, std::uint64_t point) const {
  const double place = saltelli_draw(seed_, streams_->size(), *record_input_, {point, 1});
  return drawn_index(place, draws(configuration) / draws_);
}

std::optional<Draw> Plan::draw(const Task& task) const {
  if (stated_draws_ == 0) return {};
  if (const auto row = row_of(task.draw))
    return Draw::of_saltelli(seed_, task.draw, *row, streams_);
  if (sampling_ == Sampling::kLatinHypercube)
    return Draw::of_hypercube(seed_, task.draw, most_records_ * draws_);
  if (sampling_ == Sampling::kSobol) return Draw::of_sobol(seed_, task.draw, streams_);
  return Draw(seed_, task.draw);
}

}  // namespace gurney::study
