#include "engine/base/files_read.h"

#include <sys/stat.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace gurney {
namespace {

/// Number of a file on its file system, whatever its names are.
using FileNumber = std::pair<dev_t, ino_t>;

std::optional<FileNumber> number_of(const std::string& path) {
  struct stat found;
  if (::stat(path.c_str(), &found) != 0) return {};
  return FileNumber{found.st_dev, found.st_ino};
}

/// Files with the path where each was read last: a number is given again once its file is removed.
struct FilesRead {
  std::mutex mutex;
  std::map<FileNumber, std::string> paths;
};

FilesRead& files_read() {
  static FilesRead files;
  return files;
}

}  // namespace

void note_read(const std::string& path) {
  const auto number = number_of(path);
  if (!number) return;
  std::error_code nowhere;  // where the working folder is gone
  const std::filesystem::path whole = std::filesystem::absolute(path, nowhere);
  const std::lock_guard lock(files_read().mutex);
  files_read().paths[*number] = whole.string();
}

bool was_read(const std::string& path) {
  const auto number = number_of(path);
  if (!number) return false;
  const std::lock_guard lock(files_read().mutex);
  const auto known = files_read().paths.find(*number);
  return known != files_read().paths.end() && number_of(known->second) == number;
}

}  // namespace gurney
