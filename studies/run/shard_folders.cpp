#include "studies/run/shard_folders.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/base/files.h"
#include "studies/run/study_identity.h"

namespace gurney::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kListed = 12;  ///< shards or tasks in a message

fs::path log_of(const fs::path& folder, const Shard& shard) {
  return folder / (shard.folder() + ".log");
}

/// The shards that have a folder with the file `study`, in no order.
std::vector<std::pair<Shard, fs::path>> started_shards(const fs::path& folder) {
  std::vector<std::pair<Shard, fs::path>> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto shard = shard_of_folder(entry.path().filename().string());
    if (!shard || !is_there(entry.path() / "study")) continue;
    require(!entry.is_symlink(), entry.path().string() +
                                     ": is a link; a shard is a folder, which is removed after the "
                                     "merge");
    found.emplace_back(*shard, entry.path());
  }
  return found;
}

/// The path of the job, also as a killed process left it (OutputFiles).
bool is_job_file(const std::string& name) { return name == "job" || name.starts_with("job.part"); }

}  // namespace

fs::path shards_path(const fs::path& results) { return results.string() + ".shards"; }

void refuse_shards_of_another_study(const fs::path& own, const std::string& identity) {
  for (const auto& [shard, path] : started_shards(own.parent_path())) {
    const IdentityFile study(path);
    if (path == own || !study.exists() || study.damaged() || study.identity() == identity) continue;
    throw Error(fmt::format(
        "{}: contains runs of another study, which `gurney merge` would refuse: {}; remove it, "
        "give another name with -o, or start each shard again with --overwrite",
        path.string(), difference(study.identity(), identity)));
  }
}

std::vector<std::pair<Shard, fs::path>> shards_in(const fs::path& folder) {
  require(is_folder(folder), folder.string() + ": is not a folder of shards");
  std::vector<std::pair<Shard, fs::path>> found = started_shards(folder);
  require(!found.empty(), folder.string() + ": holds no shards, which are folders such as 3-of-8");
  std::ranges::sort(
      found, {}, [](const auto& each) { return std::pair(each.first.count, each.first.number); });
  return found;
}

ShardFolders::ShardFolders(fs::path folder, const std::string& identity, std::size_t tasks)
    : folder_(std::move(folder)), of_task_(tasks, kNone) {
  for (const auto& [shard, path] : shards_in(folder_)) {
    folders_.push_back(
        std::make_unique<PartFolder>(path, identity, tasks, PartFolder::Start::kResume, shard));
    shards_.push_back(shard);
    const PartFolder& parts = *folders_.back();
    append_all(warnings_, parts.warnings());
    for (std::size_t task = 0; task < tasks; ++task)
      if (of_task_[task] == kNone && parts.has(task)) of_task_[task] = folders_.size() - 1;
  }
}

std::string ShardFolders::missing() const {
  std::vector<std::size_t> missing;
  for (std::size_t task = 0; task < of_task_.size(); ++task)
    if (of_task_[task] == kNone) missing.push_back(task);
  if (missing.empty()) return {};
  std::string text = fmt::format("{}: {} of {} analysis cases are missing", folder_.string(),
                                 missing.size(), of_task_.size());
  if (shards_.back().count == shards_.front().count) {
    std::size_t listed = 0;
    for (const auto& [shard, lacking] : incomplete()) {
      if (++listed > kListed) return text + "\n  and more";
      text += fmt::format("\n  shard {}/{} lacks {} of {}", shard.number, shard.count, lacking,
                          shard.tasks_of(of_task_.size()));
    }
    return text;
  }
  missing.resize(std::min(missing.size(), kListed));
  return text +
         fmt::format(", such as {}; the shards are of several counts", fmt::join(missing, ", "));
}

std::vector<ShardFolders::Incomplete> ShardFolders::incomplete() const {
  const std::size_t count = shards_.front().count;
  std::vector<Incomplete> found;
  if (shards_.back().count != count) return found;  // they are sorted
  for (std::size_t number = 1; number <= count; ++number) {
    Incomplete each{{number, count}};
    for (std::size_t task = 0; task < of_task_.size(); ++task)
      each.missing += of_task_[task] == kNone && each.shard.has(task);
    if (each.missing > 0) found.push_back(each);
  }
  return found;
}

std::string ShardFolders::logs() const {
  std::string text;
  for (const Shard& shard : shards_)
    if (const fs::path log = log_of(folder_, shard); is_there(log)) text += file_bytes(log);
  return text;
}

void ShardFolders::remove() {
  for (const auto& parts : folders_) parts->remove();
  folders_.clear();
  std::error_code ignored;
  for (const Shard& shard : shards_) fs::remove(log_of(folder_, shard), ignored);
  for (const auto& entry : fs::directory_iterator(folder_, ignored))
    if (is_job_file(entry.path().filename().string())) fs::remove(entry.path(), ignored);
  fs::remove(folder_, ignored);  // unless it holds something else
}

}  // namespace gurney::study
