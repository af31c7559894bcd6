#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "studies/run/part_folder.h"
#include "studies/run/shard.h"

namespace gurney::study {

/// Folder beside a study's results: `FILE.h5.shards`. It holds a folder of parts for each shard,
/// `3-of-8`, its log, `3-of-8.log`, and the file `job` with the path of the job.
std::filesystem::path shards_path(const std::filesystem::path& results);

/// The folders of shards in a folder, by name.
/// @throws Error for a folder that does not exist, or has none, and for a shard that is a link
std::vector<std::pair<Shard, std::filesystem::path>> shards_in(const std::filesystem::path& folder);

/// Before a shard begins: its runs and those of the others beside it will be merged.
/// @throws Error where one of them is a shard of another study
void refuse_shards_of_another_study(const std::filesystem::path& shard,
                                    const std::string& identity);

/// The shards of one study, locked, with what they have finished. Shards of several counts may be
/// there, where a study was begun with one and continued with another: a task is the same in all.
class ShardFolders {
 public:
  /// @param identity  of the study; @param tasks  their number
  /// @throws Error for shards of another study, and while a process works on one
  ShardFolders(std::filesystem::path folder, const std::string& identity, std::size_t tasks);

  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Which tasks are missing, in words, by shard; empty: none.
  std::string missing() const;

  /// The shards that lack tasks; none where the shards are of several counts.
  struct Incomplete {
    Shard shard;
    std::size_t missing = 0;  ///< number of its tasks
  };
  std::vector<Incomplete> incomplete() const;

  /// The bytes of a task. @pre none is missing
  std::string read(std::size_t task) const { return folders_[of_task_[task]]->read(task); }

  /// The logs of all shards.
  std::string logs() const;

  /// Removes what this program put there, and the folder unless it holds something else.
  void remove();

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::filesystem::path folder_;
  std::vector<Shard> shards_;
  std::vector<std::unique_ptr<PartFolder>> folders_;
  std::vector<std::size_t> of_task_;  ///< index of a folder, or kNone
  std::vector<std::string> warnings_;
};

}  // namespace gurney::study
