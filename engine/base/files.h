#pragma once

#include <filesystem>

namespace gurney {

/// Queries by name, links followed. The standard library throws for a name that no file can have, as one
/// of 300 characters; here no file has it.
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
