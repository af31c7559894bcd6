#pragma once

#include <map>
#include <set>
#include <string>

namespace gurney::config {

/// The files that one study is made from, as they were when each was first read. Later reads give
/// the same bytes, whatever happened to the files meanwhile. Its scopes are those of one thread at a
/// time.
class FileSnapshot {
 public:
  /// While one exists, files that this thread reads go through the snapshot.
  class Scope {
   public:
    explicit Scope(FileSnapshot& snapshot);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    FileSnapshot* before_;
  };

  FileSnapshot() = default;
  FileSnapshot(const FileSnapshot&) = delete;
  FileSnapshot& operator=(const FileSnapshot&) = delete;

  /// Bytes of a regular file: of this thread's snapshot, else read now.
  static std::string bytes_of(const std::string& path);

  /// Whether there is such a file or folder, or was when this thread's snapshot first saw it.
  static bool exists(const std::string& path);

  /// Adds a file that was read by other means; a first reading stays.
  static void note(const std::string& path, const std::string& bytes);

  /// By absolute path.
  const std::map<std::string, std::string>& files() const { return files_; }

 private:
  std::map<std::string, std::string> files_;
  std::set<std::string> seen_;  ///< there, but not read through the snapshot
};

}  // namespace gurney::config
