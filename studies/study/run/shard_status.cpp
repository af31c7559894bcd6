#include "studies/study/run/shard_status.h"

#include <algorithm>
#include <chrono>
#include <set>

#include "engine/base/error.h"
#include "studies/study/run/folder_lock.h"
#include "studies/study/run/part_file.h"
#include "studies/study/run/part_folder.h"
#include "studies/study/run/shard_folders.h"
#include "studies/study/run/study_identity.h"

namespace gurney::study {
namespace {

namespace fs = std::filesystem;

using Time = fs::file_time_type;

Time time_of(const fs::path& file) {
  std::error_code gone;
  const Time time = fs::last_write_time(file, gone);
  return gone ? Time::min() : time;
}

/// The runs of parts that were written since the last start, and how long they took.
void measure(ShardStatus& status, std::size_t runs, std::size_t tasks, Time start, Time last) {
  const double seconds = std::chrono::duration<double>(last - start).count();
  if (runs == 0 || !(seconds > 0)) return;
  status.runs_per_second = static_cast<double>(runs) / seconds;
  status.seconds_per_task = seconds / static_cast<double>(tasks);
}

ShardStatus status_of(const fs::path& folder, const Shard& shard) {
  const std::string identity = identity_in(folder);
  const std::size_t tasks = tasks_in(identity);
  const PartFormat format(identity, tasks);
  ShardStatus status{.shard = shard, .tasks = shard.tasks_of(tasks), .started = true};
  status.process = working_process(folder);
  const Time start = time_of(folder / "lock");
  Time last = start;
  std::set<std::size_t> done;
  std::size_t runs_now = 0, tasks_now = 0;
  for (const std::uint32_t part : part_numbers(folder)) {
    const fs::path path = part_path(folder, part);
    const std::string bytes = file_bytes(path);
    const PartContent content = format.decode(bytes);
    status.damaged += !content.damage.empty();
    const bool now = time_of(path) > start;
    for (const PartEntry& entry : content.entries) {
      if (!done.insert(entry.task).second) continue;
      const std::size_t before = status.counts.runs;
      status.counts.add(task_from_bytes(std::string_view(bytes).substr(entry.offset, entry.size)));
      runs_now += now ? status.counts.runs - before : 0;
      tasks_now += now;
    }
    if (now) last = std::max(last, time_of(path));
  }
  status.done = done.size();
  measure(status, runs_now, tasks_now, start, last);
  return status;
}

}  // namespace

std::vector<ShardStatus> shard_status(const fs::path& folder) {
  if (fs::exists(folder / "study")) return {status_of(folder, {})};
  const auto found = shards_in(folder);
  std::vector<ShardStatus> all;
  for (const auto& [shard, path] : found) all.push_back(status_of(path, shard));
  if (found.front().first.count != found.back().first.count) return all;
  const std::size_t count = found.front().first.count;
  const std::size_t tasks = tasks_in(identity_in(found.front().second));
  for (std::size_t number = 1; number <= count; ++number) {
    const Shard shard{number, count};
    if (std::ranges::find(all, shard, &ShardStatus::shard) == all.end())
      all.push_back({.shard = shard, .tasks = shard.tasks_of(tasks)});
  }
  std::ranges::sort(all, {}, [](const ShardStatus& each) { return each.shard.number; });
  return all;
}

}  // namespace gurney::study
