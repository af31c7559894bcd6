#pragma once

#include <filesystem>

namespace gurney::cli {

/// A folder for the files of a command, made if it is not there; removed again unless what was put
/// into it is kept.
class NewFolder {
 public:
  /// @throws Error if it is a file, or the folder it should be in is missing or refuses
  explicit NewFolder(const std::filesystem::path& path);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  std::filesystem::path path_;
  bool made_ = false;
};

}  // namespace gurney::cli
