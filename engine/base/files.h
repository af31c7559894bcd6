#pragma once

#include <filesystem>

namespace gurney {

/// What has this name, links followed. The functions of the standard library throw where no file can have
/// it, as one of 300 characters; here nothing has it.
inline bool is_file(const std::filesystem::path& path) {
  std::error_code impossible;
  return std::filesystem::is_regular_file(path, impossible);
}

inline bool is_folder(const std::filesystem::path& path) {
  std::error_code impossible;
  return std::filesystem::is_directory(path, impossible);
}

inline bool is_there(const std::filesystem::path& path) {
  std::error_code impossible;
  return std::filesystem::exists(path, impossible);
}

}  // namespace gurney
