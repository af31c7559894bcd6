#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "engine/base/random/draw.h"
#include "studies/study/study_job.h"
#include "studies/study/study_motions.h"

namespace gurney {

/// One record on one configuration from one angle with one draw, at all its intensities: the runs
/// of a unit follow each other in one thread.
struct Unit {
  std::size_t configuration = 0, record = 0, angle = 0, draw = 0;
};

/// The units of a study in their order: configurations, in them records, in them angles, in them
/// draws. A unit's index is its identity: nothing else decides its numbers.
class Plan {
 public:
  Plan(const StudyJob& job, const StudyMotions& motions);

  std::size_t units() const { return first_.back(); }
  Unit unit(std::size_t index) const;

  /// Runs of one unit: their number, or for a hunt the most that there can be.
  std::size_t runs_of_unit() const { return runs_of_unit_; }

  /// Draw of a unit: of its record, the same in all configurations and at all angles, so that these
  /// are compared pair by pair. Empty: every number has its value.
  std::optional<Draw> draw(const Unit& unit) const;

 private:
  std::size_t angles_, draws_, runs_of_unit_;
  std::uint64_t seed_, most_records_ = 0;
  int stated_draws_;
  Sampling sampling_;
  std::shared_ptr<Draw::Streams> streams_;  ///< of Sobol sequences: those of all configurations
  std::vector<std::size_t> first_;          ///< unit of each configuration; last: their number
};

}  // namespace gurney
