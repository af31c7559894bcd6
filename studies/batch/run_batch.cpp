#include "studies/batch/run_batch.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>
#include <utility>

namespace gurney {
namespace {

using Clock = std::chrono::steady_clock;

using Part = std::map<std::size_t, std::string>;  ///< bytes of units

/// Collects finished units into parts: soon at first, later after 2 % of the time the batch has
/// run, so that parts stay few and little is lost.
class Collector {
 public:
  Collector(const std::function<void(const BatchProgress&)>& report, std::size_t units,
            std::size_t done)
      : report_(report) {
    progress_.units = units;
    progress_.done = done;
  }

  /// @return a part that is due to be written; else empty
  Part add(UnitResult result) {
    for (const StudyRun& run : result.runs) {
      progress_.failed += run.response.outcome == Outcome::kDiverged;
      progress_.overturned += run.response.outcome == Outcome::kOverturned;
    }
    progress_.runs += result.runs.size();
    ++progress_.done;
    ++progress_.units_now;
    const std::size_t unit = result.unit;
    bytes_ += (waiting_[unit] = to_bytes(result)).size();
    progress_.seconds = since(start_);
    if (since(reported_) > 0.5) {
      report_(progress_);
      reported_ = Clock::now();
    }
    const bool due = since(taken_) > std::max(1.0, 0.02 * progress_.seconds) || bytes_ > kMostBytes;
    return due ? take() : Part();
  }

  Part take() {
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
  static constexpr std::size_t kMostBytes = 8 << 20;

  static double since(Clock::time_point time) {
    return std::chrono::duration<double>(Clock::now() - time).count();
  }

  const std::function<void(const BatchProgress&)>& report_;
  BatchProgress progress_;
  Part waiting_;
  std::size_t bytes_ = 0;
  Clock::time_point start_ = Clock::now(), taken_ = start_, reported_ = start_;
};

}  // namespace

BatchProgress run_batch(const Batch& batch, PartFolder& folder, int threads,
                        const std::function<bool()>& go_on,
                        const std::function<void(const BatchProgress&)>& progress) {
  std::vector<std::size_t> missing;
  for (std::size_t unit = 0; unit < batch.plan.units(); ++unit)
    if (!folder.has(unit)) missing.push_back(unit);
  Collector collector(progress, batch.plan.units(), folder.size());
  const CrashLog crashes(folder.path() / "crashes");
  std::mutex collecting, writing;  // a thread that waits for the disk holds up no other
  std::exception_ptr problem;
  std::atomic<bool> broken = false;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
  for (std::size_t i = 0; i < missing.size(); ++i) {
    if (broken || !go_on()) continue;
    try {
      UnitResult result = run_unit(batch, missing[i], go_on, crashes.given_up());
      Part part;
      {
        const std::lock_guard lock(collecting);
        if (!result.runs.empty()) part = collector.add(std::move(result));
      }
      const std::lock_guard lock(writing);
      folder.add(part);
    } catch (...) {
      const std::lock_guard lock(collecting);
      if (!problem) problem = std::current_exception();
      broken = true;
    }
  }
  if (problem) std::rethrow_exception(problem);
  folder.add(collector.take());
  return collector.finish();
}

}  // namespace gurney
