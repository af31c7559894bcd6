#pragma once

#include <filesystem>

namespace gurney::cli {

/// Whether -o names a file: it has an ending of letters, or one of our files (docs/conventions.md). What
/// is a folder already is one.
bool names_a_file(const std::filesystem::path& output);

/// @throws Error where -o names a file for a command that writes several
void require_name_of_folder(const std::filesystem::path& output);

/// A folder for the files of a command, made if it is not there; removed again unless what was put
/// into it is kept.
class NewFolder {
 public:
  /// @param path  may end in a slash
  /// @throws Error if it is a file or named like one, or the folder it should be in is missing or refuses
  explicit NewFolder(const std::filesystem::path& path);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  std::filesystem::path path_;
  bool made_ = false;
};

}  // namespace gurney::cli
