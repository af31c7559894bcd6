#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "studies/run/run_task.h"
#include "studies/statistics/stripes.h"

namespace gurney::study {

/// The levels of each configuration in one stage after the other. They rest on the outcomes of all
/// tasks of the stages before, in the order of the tasks, and on nothing else.
class StageLevels {
 public:
  explicit StageLevels(const Batch& batch);

  std::size_t stage() const { return stage_; }
  const std::vector<double>& of(std::size_t configuration) const { return levels_[configuration]; }

  /// The next stage; all tasks of this one are done.
  /// @param read  gives a task's result
  void advance(const std::function<TaskResult(std::size_t)>& read);

 private:
  const Batch& batch_;
  std::size_t stage_ = 0;
  std::vector<std::vector<double>> levels_;
  std::vector<std::map<double, statistics::Stripe>>
      stripes_;  ///< of each configuration, by intensity
};

}  // namespace gurney::study
