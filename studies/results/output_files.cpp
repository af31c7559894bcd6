#include "studies/results/output_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "engine/base/error.h"

namespace gurney {
namespace {

std::string part_of(const std::string& path) { return path + ".part"; }

[[noreturn]] void fail(const std::string& path, const std::string& what, int error) {
  throw Error(path + ": " + what + ": " + std::strerror(error));
}

/// An open file that is closed in any case.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }
  bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// After this the new names survive a power cut; some file systems cannot, which is no error.
void sync_folder(const std::string& path) {
  const Descriptor folder(::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() >= 0) ::fsync(folder.get());
}

}  // namespace

OutputFiles::~OutputFiles() {
  for (const std::string& path : staged_) ::unlink(part_of(path).c_str());
}

void OutputFiles::check(const std::string& path) const {
  std::error_code ignored;
  const std::string folder = folder_of(path);
  require(!std::filesystem::is_directory(path, ignored),
          path + ": is a folder, the name of a file is needed");
  require(std::filesystem::is_directory(folder, ignored),
          path + ": cannot be written: the folder " + folder + " does not exist");
  require(overwrite_ || !std::filesystem::exists(path, ignored),
          path + ": exists already; give another name with -o, or --overwrite to replace it");
  const Descriptor probe(
      ::open(part_of(path).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (probe.get() < 0) fail(path, "cannot be written", errno);
  ::unlink(part_of(path).c_str());
}

void OutputFiles::stage(const std::string& path, std::string_view bytes) {
  Descriptor file(::open(part_of(path).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (file.get() < 0) fail(path, "cannot be written", errno);
  staged_.push_back(path);
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path, "cannot be written, nothing was kept", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fsync(file.get()) != 0) fail(path, "cannot be written, nothing was kept", errno);
  if (!file.close()) fail(path, "cannot be written, nothing was kept", errno);
}

void OutputFiles::commit() {
  for (const std::string& path : staged_) {
    std::error_code ignored;
    require(overwrite_ || !std::filesystem::exists(path, ignored),
            path + ": was made by somebody else meanwhile; it was left alone");
  }
  for (; !staged_.empty(); staged_.pop_back()) {
    const std::string& path = staged_.back();
    if (std::rename(part_of(path).c_str(), path.c_str()) != 0)
      fail(path, "cannot be put in place", errno);
    sync_folder(path);
  }
}

void put_in_place(const std::string& made, const std::string& path) {
  const Descriptor file(::open(made.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0 || ::fsync(file.get()) != 0) fail(path, "cannot be written", errno);
  if (std::rename(made.c_str(), path.c_str()) != 0) fail(path, "cannot be put in place", errno);
  sync_folder(path);
}

}  // namespace gurney
