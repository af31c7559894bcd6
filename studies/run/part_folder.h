#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "studies/run/shard.h"

namespace gurney::study {

/// The sole right to work in a folder: a lock on its file `lock`, which is never replaced and which
/// the system gives up when the process ends, in whatever way.
class FolderLock {
 public:
  /// Makes the folder where it is missing.
  /// @throws Error while another process has it, naming that process; for a link, or a folder that
  ///         cannot be made; for one with files of others and without a file `study`, where nothing
  ///         is touched
  explicit FolderLock(std::filesystem::path folder);
  ~FolderLock();  ///< a folder without a file `study` goes, unless it holds files of others
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

  /// Why the folder could not be locked, on a file system without locks; else empty.
  const std::string& warning() const { return warning_; }

  /// Whether the folder is still there with this lock in it.
  bool holds() const;

  /// @throws Error unless holds()
  void check() const;

 private:
  bool try_lock();

  std::filesystem::path folder_, file_;
  int descriptor_ = -1;
  std::string warning_;
};

/// The process that works in a folder, "process 12 on node3"; empty: none.
std::string working_process(const std::filesystem::path& folder);

/// Removes a folder that holds nothing but a lock which nobody has: its owner ended while removing
/// it.
void remove_abandoned(const std::filesystem::path& folder);

/// Whether a name in the folder of parts is one that this program gives.
bool is_own_name(const std::string& name);

/// Bytes of tasks, by their indices.
using TaskBytes = std::map<std::size_t, std::string>;

/// Where the bytes of a task are in a part file.
struct PartEntry {
  std::size_t task = 0;
  std::uint64_t offset = 0, size = 0;
};

/// Content of a part file: whole tasks, each with a SHA-256 that binds it to its study and its
/// number, and at the end the SHA-256 of all before.
struct PartContent {
  std::vector<PartEntry> entries;
  std::string damage;    ///< why it cannot be used; empty: nothing
  bool foreign = false;  ///< it is whole, and of another study
};

/// Encodes and decodes the part files of one study.
/// @param identity  of the study (study_identity.h)
/// @param tasks     their number
class PartFormat {
 public:
  PartFormat(const std::string& identity, std::size_t tasks);

  std::string encode(const TaskBytes& tasks, std::vector<PartEntry>& entries) const;
  PartContent decode(std::string_view bytes) const;

  /// The bytes of one task.
  /// @throws Error unless they are those that were encoded
  std::string read(const std::filesystem::path& file, const PartEntry& entry) const;

 private:
  std::string hash_of(std::size_t task, std::string_view bytes) const;

  std::string identity_hash_;
  std::size_t tasks_;
};

std::filesystem::path part_path(const std::filesystem::path& folder, std::uint32_t part);

/// Numbers of the part files of a folder, increasing.
std::vector<std::uint32_t> part_numbers(const std::filesystem::path& folder);

/// The bytes of a file that this program wrote.
std::string file_bytes(const std::filesystem::path& path);

/// The finished tasks of a study that is not complete: a folder beside its results file.
///
/// A part file (part_file.h) is written under another name, synced and renamed, so that a killed
/// process loses only tasks it had not reported. The file `study` (study_identity.h) states whose
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

  /// Each shard has one of as many consecutive tasks as there are shards.
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
