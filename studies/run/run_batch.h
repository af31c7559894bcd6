#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "studies/run/part_folder.h"
#include "studies/run/run_task.h"
#include "studies/run/shard.h"
#include "studies/statistics/fragility.h"

namespace gurney::study {

/// The levels of each configuration in one stage after the other. They rest on the outcomes of all
/// tasks of the stages before, in the order of the tasks, and on nothing else.
class StageLevels {
 public:
  explicit StageLevels(const Batch& batch);

  std::size_t stage() const { return stage_; }
  std::vector<double> of(const Task& task) const;

  /// The next stage; all tasks of this one are done.
  /// @param read  gives a task's result
  void advance(const std::function<TaskResult(std::size_t)>& read);

 private:
  const Batch& batch_;
  std::size_t stage_ = 0;
  std::vector<std::vector<double>> levels_;  ///< of each configuration after the first stage
  std::vector<std::map<double, statistics::Stripe>>
      stripes_;  ///< of each configuration, by intensity
};

/// Progress of a batch.
struct BatchProgress : RunCounts {          // of the tasks that are done
  std::size_t tasks = 0, done = 0;          ///< those of earlier attempts included
  std::size_t tasks_now = 0, runs_now = 0;  ///< of this attempt
  double seconds = 0;                       ///< of this attempt
  std::size_t stage = 0;    ///< of adaptive stripes, from 0, where the attempt ended
  std::size_t awaited = 0;  ///< tasks of that stage that other shards have not finished
};

/// Runs every task of a shard that the folder lacks, and puts it there. A run that crashed the
/// program twice (crash_log.h) fails without being tried again.
/// @param crashes   of this folder
/// A stage after the first rests on all tasks of those before: a shard reads those of the others, in
/// folders beside its own, and ends where they are not finished (BatchProgress::awaited).
/// @param threads   >= 1
/// @param go_on     false: runs in flight are dropped, what is finished goes to the folder
/// @param progress  called about twice a second, from one thread at a time
/// @throws Error where the folder cannot take the parts; finished tasks before that stay in it
BatchProgress run_batch(const Batch& batch, PartFolder& folder, const CrashLog& crashes,
                        const Shard& shard, int threads, const std::function<bool()>& go_on,
                        const std::function<void(const BatchProgress&)>& progress);

}  // namespace gurney::study
