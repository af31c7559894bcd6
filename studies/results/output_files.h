#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gurney::study {

/// The files a command leaves: all of them complete, or none.
///
/// Each is written to a new file `FILE.part` in its own folder and synced; commit() renames them.
/// Whatever is not committed is removed again. An existing file stays as it is until the new one is
/// complete; without `overwrite` it stays in any case.
class OutputFiles {
 public:
  explicit OutputFiles(bool overwrite) : overwrite_(overwrite) {}
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// To be called before the work starts.
  /// @throws Error unless `path` can be written: it exists and may not be overwritten, is a folder,
  ///         is a file that this process has read, or its folder is missing or refuses new files.
  void check(const std::string& path) const;

  /// Writes `bytes` beside `path`.
  /// @throws Error with the system's reason, such as a full disk.
  void stage(const std::string& path, std::string_view bytes);

  /// Gives the staged files their names.
  /// @throws Error where somebody made such a file meanwhile and it may not be overwritten
  void commit();

 private:
  struct Staged {
    std::string path, part;
  };
  bool overwrite_;
  std::vector<Staged> staged_;
};

/// @throws Error where `path` is a file that this process has read, such as the job
void refuse_input(const std::string& path);

/// Syncs a finished file and gives it its name, on one file system.
/// @param overwrite  false: never over a file that is there
/// @throws Error with the reason; then the finished file is where it was
void put_in_place(const std::string& made, const std::string& path, bool overwrite);

}  // namespace gurney::study
