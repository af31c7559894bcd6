#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "studies/run/folder_lock.h"
#include "studies/run/part_file.h"
#include "studies/run/shard.h"

namespace gurney::study {

/// The finished tasks of a study that is not complete: a folder beside its results file.
///
/// A part file (part_file.h) is written under another name, synced and renamed, so that a killed
/// process loses only tasks it had not reported. The file `study` (identity_file.h) states whose
/// parts these are; each part does as well, so that a damaged one can be written again. One process
/// works in the folder at a time (FolderLock).
class PartFolder {
 public:
  enum class Start {
    kNew,     ///< there must be no parts
    kResume,  ///< parts of this study are taken over
    kReplace  ///< parts are removed
  };

  /// @param identity  what must be equal for tasks to belong together: lines `key value`, an empty
  ///                  line, and whatever else is to be kept with it
  /// @param tasks     of the study: their numbers are below
  /// @throws Error for parts that must not be there, for parts of another study, where nothing can
  ///         be written, and as FolderLock does. Damaged parts are renamed to `.damaged` and
  ///         reported in warnings(): their tasks are not done.
  /// @param shard  whose tasks the folder holds; those of others are not seen
  PartFolder(std::filesystem::path folder, const std::string& identity, std::size_t tasks,
             Start start, const Shard& shard = {});
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;

  const std::filesystem::path& path() const { return lock_.folder(); }
  const std::vector<std::string>& warnings() const { return warnings_; }
  bool has(std::size_t task) const {
    return shard_.has(task) && index_of(task) < places_.size() && places_[index_of(task)].part > 0;
  }
  std::size_t size() const { return size_; }
  std::uint32_t next_part() const { return next_; }

  /// Whether the folder with its parts is still there.
  bool holds() const { return lock_.holds(); }

  /// Writes a part of these tasks, in any order.
  /// @throws Error with the system's reason, such as a full disk, and where the folder was removed:
  ///         then none of them counts
  void add(const TaskBytes& tasks);

  /// The bytes of a task.
  /// @throws Error unless they are those that were added
  std::string read(std::size_t task) const;

  /// Removes what this program put there, and the folder unless somebody put other files into it.
  void remove();

 private:
  struct Place {
    std::uint32_t part = 0;  ///< from 1; 0: the task is not done
    PartEntry entry;
  };
  void start(const std::string& identity, Start start);
  void restore(const std::string& problem, const std::vector<std::uint32_t>& parts);
  void take_over(std::uint32_t part);
  void place(std::uint32_t part, const PartEntry& entry);

  /// Of as many tasks as there are shards, which follow each other, each shard has one.
  std::size_t index_of(std::size_t task) const { return task / shard_.count; }

  FolderLock lock_;
  PartFormat format_;
  std::uint32_t next_ = 1;
  std::size_t size_ = 0;
  Shard shard_;
  std::vector<Place> places_;  ///< by index_of(task): memory for the tasks of this shard alone
  std::vector<std::string> warnings_;
};

}  // namespace gurney::study
