#include "engine/base/input_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "engine/base/error.h"
#include "engine/base/files_read.h"

namespace gurney {

namespace fs = std::filesystem;

void require_regular_file(const std::string& path) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  require(!fs::is_directory(status), path + ": is a folder, not a file");
  require(fs::exists(status), path + ": no such file");
  require(fs::is_regular_file(status), path + ": is a pipe or a device, not a regular file");
}

std::string read_input_file(const std::string& path, std::uintmax_t largest) {
  require_regular_file(path);
  std::error_code failure;
  const std::uintmax_t size = fs::file_size(path, failure);
  require(!failure, path + ": cannot be read");
  require(size <= largest,
          fmt::format("{}: has {} bytes; must have at most {}", path, size, largest));
  note_read(path);
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(size, '\0');
  if (size > 0) stream.read(bytes.data(), static_cast<std::streamsize>(size));
  require(stream.is_open() && !stream.bad(), path + ": cannot be read");
  bytes.resize(static_cast<std::size_t>(size > 0 ? stream.gcount() : 0));
  return bytes;
}

}  // namespace gurney
