#pragma once

#include <filesystem>
#include <string>

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

}  // namespace gurney::study
