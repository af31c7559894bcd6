#include "studies/run/shard_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "studies/run/part_folder.h"
#include "studies/run/shard_folders.h"
#include "studies/run/study_file.h"
#include "studies/run/study_identity.h"

namespace gurney::study {
namespace {

namespace fs = std::filesystem;

/// Work since a start, and its duration. Dates of files would not do: clocks are set.
struct Attempt {
  std::size_t runs = 0, tasks = 0;
  double seconds = 0;

  void add(const TaskResult& result) {
    runs += result.runs.size();
    ++tasks;
    seconds = std::max(seconds, result.cost.ended);
  }
};

void add_to_record(RecordTime& record, const TaskResult& result) {
  record.runs += result.runs.size();
  record.seconds += result.cost.cpu_seconds;
}

/// Shards of one study, each added by its folder.
class Counter {
 public:
  explicit Counter(std::string identity)
      : identity_(std::move(identity)), stages_(stages_in(identity_)), done_(tasks_in(identity_)) {
    study_.tasks = done_.size();
  }

  void add(const fs::path& folder, const Shard& shard) {
    study_.shards.push_back(status_of(folder, shard));
  }
  void add_not_started(const Shard& shard) {
    study_.shards.push_back({.shard = shard, .tasks = shard.tasks_of(study_.tasks)});
  }
  StudyStatus& study() { return study_; }

 private:
  ShardStatus status_of(const fs::path& folder, const Shard& shard);
  void add(const TaskResult& result) {
    if (done_.at(result.task)) return;
    done_[result.task] = true;
    ++study_.done;
    study_.counts.add(result);
  }

  std::string identity_;
  std::size_t stages_;
  std::vector<bool> done_;  ///< by task
  StudyStatus study_;
};

ShardStatus Counter::status_of(const fs::path& folder, const Shard& shard) {
  const std::size_t tasks = study_.tasks;
  const PartFormat format(identity_, tasks);
  ShardStatus status{.shard = shard, .tasks = shard.tasks_of(tasks), .started = true};
  status.process = working_process(folder);
  status.other_study = IdentityFile(folder).identity() != identity_;
  if (status.other_study) return status;
  std::set<std::size_t> done;
  std::map<std::uint64_t, Attempt> attempts;
  for (const std::uint32_t part : part_numbers(folder)) {
    const fs::path path = part_path(folder, part);
    const std::string bytes = file_bytes(path);
    const PartContent content = format.decode(bytes);
    status.damaged += !content.damage.empty();
    for (const PartEntry& entry : content.entries) {
      status.foreign += !shard.has(entry.task);
      if (!shard.has(entry.task)) continue;
      if (!done.insert(entry.task).second) continue;
      const TaskResult result =
          task_from_bytes(std::string_view(bytes).substr(entry.offset, entry.size));
      status.counts.add(result);
      add(result);
      add_to_record(status.records[result.cost.record], result);
      attempts[result.cost.attempt].add(result);
    }
  }
  status.done = done.size();
  status.stages = stages_;
  for (std::size_t stage = 1; stage < stages_ && !done.empty(); ++stage) {
    const std::size_t end = stage * tasks / stages_;
    if (*done.rbegin() < end && done.size() == shard.tasks_of(end)) status.stage = stage;
  }
  if (attempts.empty()) return status;
  const Attempt& last = attempts.rbegin()->second;
  if (!(last.seconds > 0)) return status;
  status.runs_per_second = static_cast<double>(last.runs) / last.seconds;
  status.seconds_per_task = last.seconds / static_cast<double>(last.tasks);
  return status;
}

/// The study that most shards are of; of equally many the first.
std::string identity_of_most(const std::vector<std::pair<Shard, fs::path>>& shards) {
  std::vector<std::string> identities;
  for (const auto& [shard, path] : shards) identities.push_back(IdentityFile(path).identity());
  return *std::ranges::max_element(identities, {}, [&](const std::string& identity) {
    return std::ranges::count(identities, identity);
  });
}

}  // namespace

StudyStatus study_status(const fs::path& folder) {
  if (is_there(folder / "study")) {
    Counter alone(IdentityFile(folder).identity());
    alone.add(folder, {});
    return alone.study();
  }
  const auto found = shards_in(folder);
  Counter counter(identity_of_most(found));
  std::vector<ShardStatus>& all = counter.study().shards;
  for (const auto& [shard, path] : found) counter.add(path, shard);
  if (found.front().first.count != found.back().first.count) return counter.study();
  const std::size_t count = found.front().first.count;
  for (std::size_t number = 1; number <= count; ++number) {
    const Shard shard{number, count};
    if (std::ranges::find(all, shard, &ShardStatus::shard) == all.end())
      counter.add_not_started(shard);
  }
  std::ranges::sort(all, {}, [](const ShardStatus& each) { return each.shard.number; });
  return counter.study();
}

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> folders_in(const fs::path& folder) {
  if (fs::exists(folder / "study")) return {folder};
  std::vector<fs::path> folders;
  for (const auto& [shard, path] : shards_in(folder)) folders.push_back(path);
  return folders;
}

}  // namespace

FinishedCases::FinishedCases(const fs::path& folder) {
  for (const fs::path& each : folders_in(folder)) {
    const std::string identity = IdentityFile(each).identity();
    if (identity_.empty()) {
      identity_ = identity;
      places_.resize(tasks_in(identity));
    }
    require(identity == identity_, fmt::format("{}: {} is a part of another study", folder.string(),
                                               each.filename().string()));
    take(each);
  }
}

void FinishedCases::take(const fs::path& folder) {
  const PartFormat format(identity_, places_.size());
  for (const std::uint32_t part : part_numbers(folder)) {
    const fs::path file = part_path(folder, part);
    const PartContent content = format.decode(file_bytes(file));
    damaged_ += !content.damage.empty();
    for (const PartEntry& entry : content.entries) {
      finished_ += places_.at(entry.task).file.empty();
      places_[entry.task] = {file, entry};
    }
  }
}

TaskResult FinishedCases::read(std::size_t task) const {
  const Place& place = places_.at(task);
  return task_from_bytes(PartFormat(identity_, places_.size()).read(place.file, place.entry));
}

void FinishedCases::write(const std::string& path, const std::string& job_file) const {
  const StudyJob job(job_text_in(identity_), job_file);
  const StudyMotions motions(job);
  const Plan plan(job, motions);
  const Batch batch{job, motions, plan};
  const std::string now = identity_of(batch);
  require(now == identity_,
          "the study cannot be read with what is here now: " + difference(identity_, now));
  write_study_file(
      path, batch, [this](std::size_t task) { return read(task); },
      [this](std::size_t task) { return has(task); });
}

}  // namespace gurney::study
