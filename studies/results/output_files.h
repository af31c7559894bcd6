#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gurney {

/// The files a command leaves: all of them complete, or none.
///
/// Each is written to `FILE.part` in its own folder and synced; commit() renames them. Whatever is
/// not committed is removed again. An existing file stays as it is until the new one is complete.
class OutputFiles {
 public:
  explicit OutputFiles(bool overwrite) : overwrite_(overwrite) {}
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// To be called before the work starts.
  /// @throws Error unless `path` can be written: it exists and may not be overwritten, is a folder,
  ///         or its folder is missing or refuses new files.
  void check(const std::string& path) const;

  /// Writes `bytes` beside `path`.
  /// @throws Error with the system's reason, such as a full disk.
  void stage(const std::string& path, std::string_view bytes);

  /// Gives the staged files their names.
  void commit();

 private:
  bool overwrite_;
  std::vector<std::string> staged_;
};

/// Syncs a finished file and gives it its name, in one folder.
/// @throws Error with the system's reason
void put_in_place(const std::string& made, const std::string& path);

}  // namespace gurney
