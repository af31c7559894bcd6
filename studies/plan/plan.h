#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/random/draw.h"
#include "studies/plan/study_job.h"
#include "studies/plan/study_motions.h"

namespace gurney::study {

/// One record on one configuration from one angle with one draw, at all its intensities of a stage:
/// the runs of a task follow each other in one thread.
struct Task {
  std::size_t configuration = 0, record = 0, angle = 0;
  std::size_t draw = 0;     ///< its number among the draws of all records
  std::size_t stage = 0;    ///< of adaptive stripes
  std::size_t replica = 0;  ///< of the draw: number of replica_of()
};

/// The tasks of a study in their order: stages, in them configurations, in them records, in them
/// angles, in them draws, in them replicas. A task's index is its identity: nothing else decides
/// its numbers.
///
/// In a Saltelli design each draw is a row of it, and each point has a row in each matrix. The
/// record is an input as the drawn numbers are, if there are several: matrix A has each record for
/// study.draws points that follow each other, the record's first coordinate being the point's
/// number (Hammersley 1960), and B has records by the Sobol sequence.
class Plan {
 public:
  /// @throws Error for a Saltelli design without numbers that are drawn, or with too many, and for
  ///         more runs than can be counted
  Plan(const StudyJob& job, const StudyMotions& motions);

  std::size_t tasks() const { return stages_ * tasks_of_stage(); }
  std::size_t stages() const { return stages_; }  ///< 1 but for adaptive stripes
  std::size_t tasks_of_stage() const { return first_.back(); }
  Task task(std::size_t index) const;

  /// Runs of all tasks: their number, or for an IDA the most that there can be.
  std::size_t runs() const;

  /// Runs of one task of the first stage, as runs().
  std::size_t runs_of_task() const { return runs_of_task_; }

  std::size_t draws(std::size_t configuration) const;

  /// Inputs of a Saltelli design in their order: `group treads`, `record`, `variable mass_kg`.
  /// Union over the configurations; none: the study has no such design.
  std::vector<std::string> inputs() const;

  /// Draw of a task: of its record, the same in all configurations and at all angles, so that these
  /// are compared pair by pair. Empty: every parameter has its value.
  std::optional<Draw> draw(const Task& task) const;

 private:
  void refuse_uncountable(const std::string& job, double motions) const;
  std::optional<SaltelliRow> row_of(std::size_t draw) const;
  std::size_t record_in_b(std::size_t configuration, std::uint64_t point) const;

  std::size_t stages_, angles_, draws_, replicas_, runs_of_task_;  ///< draws of each record
  std::uint64_t seed_, most_records_ = 0;
  int stated_draws_;
  Sampling sampling_;
  std::shared_ptr<Draw::Streams> streams_;     ///< of Sobol and Saltelli: of all configurations
  std::optional<std::uint64_t> record_input_;  ///< of a Saltelli design with several records
  std::vector<std::size_t> first_;             ///< task of each configuration; last: their number
};

}  // namespace gurney::study
