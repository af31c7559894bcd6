#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "engine/base/error.h"

/// What the fuzzers of readers promise themselves: from any bytes a reader makes a model, or throws
/// an Error that says something. libFuzzer reports whatever else happens, and limits time and
/// memory (fuzz.sh).
namespace gurney::fuzz {

template <class Read>
void feed(Read read) {
  try {
    read();
  } catch (const Error& error) {
    if (std::string(error.what()).empty()) std::abort();
  }
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A file for readers that take a path: the same one for every input of a process.
class InputFile {
 public:
  /// @param name  of the file; its ending may tell its kind
  explicit InputFile(const std::string& name)
      : folder_(std::filesystem::temp_directory_path() /
                ("gurney_fuzz_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
    path_ = (folder_ / name).string();
  }
  ~InputFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& with(const std::string& bytes) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes;
    return path_;
  }

 private:
  std::filesystem::path folder_;
  std::string path_;
};

}  // namespace gurney::fuzz
