#include "studies/run/run_batch.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <mutex>
#include <tuple>
#include <utility>

#include "engine/base/parallel.h"
#include "studies/plan/stages.h"
#include "studies/run/shard_status.h"

namespace gurney::study {

StageLevels::StageLevels(const Batch& batch)
    : batch_(batch), levels_(batch.job.configurations().size()), stripes_(levels_.size()) {
  for (auto& stripes : stripes_)
    for (const double level : batch.job.study().intensity.levels) stripes[level].im = level;
}

std::vector<double> StageLevels::of(const Task& task) const {
  return stage_ > 0 ? levels_[task.configuration]
                    : batch_.motions.set_of(task.configuration).levels(task.record);
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

namespace {

using Clock = std::chrono::steady_clock;

void count(const TaskResult& result, BatchProgress& progress) {
  progress.add(result);
  ++progress.done;
}

BatchProgress done_before(const Batch& batch, const PartFolder& folder, const Shard& shard) {
  BatchProgress progress;
  for (std::size_t task = 0; task < batch.plan.tasks(); ++task) {
    if (!shard.has(task)) continue;
    ++progress.tasks;
    if (folder.has(task)) count(task_from_bytes(folder.read(task)), progress);
  }
  return progress;
}

/// Collects finished tasks into parts: soon at first, later after 2 % of the time the batch has
/// run, so that parts stay few and little is lost.
class Collector {
 public:
  /// @param attempt  see TaskCost
  Collector(const std::function<void(const BatchProgress&)>& report, const BatchProgress& before,
            std::uint64_t attempt)
      : report_(report), progress_(before), attempt_(attempt) {}

  /// @return a part that is due to be written; else empty
  TaskBytes add(TaskResult result) {
    count(result, progress_);
    progress_.runs_now += result.runs.size();
    ++progress_.tasks_now;
    const std::size_t task = result.task;
    progress_.seconds = since(start_);
    result.cost.attempt = attempt_;
    result.cost.ended = progress_.seconds;
    bytes_ += (waiting_[task] = to_bytes(result)).size();
    if (since(reported_) > 0.5) {
      report_(progress_);
      reported_ = Clock::now();
    }
    const bool due = since(taken_) > std::max(1.0, 0.02 * progress_.seconds) || bytes_ > kMaxBytes;
    return due ? take() : TaskBytes();
  }

  TaskBytes take() {
    bytes_ = 0;
    taken_ = Clock::now();
    return std::exchange(waiting_, {});
  }

  BatchProgress finish() {
    progress_.seconds = since(start_);
    report_(progress_);
    return progress_;
  }

 private:
  static constexpr std::size_t kMaxBytes = 8 << 20;

  static double since(Clock::time_point time) {
    return std::chrono::duration<double>(Clock::now() - time).count();
  }

  const std::function<void(const BatchProgress&)>& report_;
  BatchProgress progress_;
  std::uint64_t attempt_;
  TaskBytes waiting_;
  std::size_t bytes_ = 0;
  Clock::time_point start_ = Clock::now(), taken_ = start_, reported_ = start_;
};

/// Duration of the ground motion of a task [s].
double duration_of(const Batch& batch, std::size_t index) {
  const Task task = batch.plan.task(index);
  return batch.motions.set_of(task.configuration).ground(task.record).duration;
}

/// Tasks of the stage and shard that the folder lacks, those of the longest motions first, so that
/// no thread is left alone with a long one at the end; those of one motion together, so that its
/// floor motions are made once.
std::vector<std::size_t> missing_tasks(const Batch& batch, std::size_t stage, const Shard& shard,
                                       const PartFolder& folder) {
  const std::size_t tasks = batch.plan.tasks_of_stage();
  std::vector<std::size_t> missing;
  for (std::size_t task = stage * tasks; task < (stage + 1) * tasks; ++task)
    if (shard.has(task) && !folder.has(task)) missing.push_back(task);
  std::vector<std::tuple<double, std::size_t, std::size_t, std::size_t>> keys;
  for (const std::size_t index : missing) {
    const Task task = batch.plan.task(index);
    keys.emplace_back(-duration_of(batch, index), batch.motions.index_of(task.configuration),
                      task.record, index);
  }
  std::ranges::sort(keys);
  std::ranges::transform(keys, missing.begin(), [](const auto& key) { return std::get<3>(key); });
  return missing;
}

/// Tasks of a stage that no shard has finished.
std::size_t unfinished(const Batch& batch, std::size_t stage, const FinishedCases& all) {
  const std::size_t tasks = batch.plan.tasks_of_stage();
  std::size_t count = 0;
  for (std::size_t task = stage * tasks; task < (stage + 1) * tasks; ++task)
    count += !all.has(task);
  return count;
}

/// CPU time of this thread: a busy machine does not make a record look slow.
double cpu_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// State that the threads of a batch share.
struct Work {
  const Batch& batch;
  PartFolder& folder;
  const CrashLog& crashes;
  Collector& collector;
  const std::function<bool()>& go_on;
};

void run_tasks(const Work& work, const std::vector<std::size_t>& tasks, const StageLevels& levels,
               int threads) {
  std::mutex collecting, writing;  // a thread that waits for the disk holds up no other
  const auto run_one = [&](std::size_t i) {
    if (!work.go_on()) return;
    const Task task = work.batch.plan.task(tasks[i]);
    const double before = cpu_seconds();
    const std::vector<double> values = levels.of(task);
    TaskResult result =
        run_task(work.batch, tasks[i], work.go_on, work.crashes.given_up(), &values);
    result.cost.record = work.batch.motions.set_of(task.configuration).name(task.record);
    result.cost.cpu_seconds = cpu_seconds() - before;
    TaskBytes part;
    {
      const std::lock_guard lock(collecting);
      if (!result.runs.empty()) part = work.collector.add(std::move(result));
    }
    const std::lock_guard lock(writing);
    work.folder.add(part);
  };
  try {
    parallel_for(tasks.size(), threads, run_one);
  } catch (...) {
    try {
      work.folder.add(work.collector.take());  // what is finished is kept
    } catch (...) {  // NOLINT(bugprone-empty-catch): the first error says why
    }
    throw;
  }
  work.folder.add(work.collector.take());
}

}  // namespace

BatchProgress run_batch(const Batch& batch, PartFolder& folder, const CrashLog& crashes,
                        const Shard& shard, int threads, const std::function<bool()>& go_on,
                        const std::function<void(const BatchProgress&)>& progress) {
  Collector collector(progress, done_before(batch, folder, shard), folder.next_part());
  const Work work{batch, folder, crashes, collector, go_on};
  StageLevels levels(batch);
  std::size_t awaited = 0;
  run_tasks(work, missing_tasks(batch, 0, shard, folder), levels, threads);
  while (levels.stage() + 1 < batch.plan.stages() && go_on()) {
    if (!missing_tasks(batch, levels.stage(), shard, folder).empty()) break;
    if (shard.count == 1) {
      levels.advance([&](std::size_t task) { return task_from_bytes(folder.read(task)); });
    } else {
      const FinishedCases all(folder.path().parent_path());
      if ((awaited = unfinished(batch, levels.stage(), all)) > 0) break;
      levels.advance([&](std::size_t task) { return all.read(task); });
    }
    run_tasks(work, missing_tasks(batch, levels.stage(), shard, folder), levels, threads);
  }
  BatchProgress ended = collector.finish();
  ended.stage = levels.stage();
  ended.awaited = awaited;
  return ended;
}

}  // namespace gurney::study
