#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
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

/// A file for readers that take a path: the same one for every input of a process. It is kept open,
/// since to make a file anew takes longer than most readers; fuzz.sh puts it into memory.
class InputFile {
 public:
  /// @param name  of the file; its ending may tell its kind
  explicit InputFile(const std::string& name)
      : folder_(std::filesystem::temp_directory_path() /
                ("gurney_fuzz_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
    path_ = (folder_ / name).string();
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file_ < 0) std::abort();
  }
  ~InputFile() {
    ::close(file_);
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& with(const std::string& bytes) const {
    const auto size = static_cast<ssize_t>(bytes.size());
    if (::ftruncate(file_, size) != 0 || ::pwrite(file_, bytes.data(), bytes.size(), 0) != size)
      std::abort();
    return path_;
  }

 private:
  std::filesystem::path folder_;
  std::string path_;
  int file_ = -1;
};

}  // namespace gurney::fuzz
