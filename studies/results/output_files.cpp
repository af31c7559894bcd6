#include "studies/results/output_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/files_read.h"

namespace gurney::study {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what, int error) {
  throw Error(path + ": " + what + ": " + std::strerror(error));
}

/// An open file that is closed in any case.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }
  bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

struct NewFile {
  std::string path;
  Descriptor file;
};

/// A file that nobody has, beside `path`: `path.part`, or where that is taken `path.part2` and so
/// on. It never follows a link nor touches what is there, which may be somebody's.
NewFile new_file_beside(const std::string& path) {
  constexpr int kMax = 1000;
  for (int number = 1;; ++number) {
    std::string name = path + ".part" + (number == 1 ? "" : std::to_string(number));
    Descriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.get() >= 0) return {std::move(name), std::move(file)};
    if (errno != EEXIST || number == kMax) fail(path, "cannot be written", errno);
  }
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// @throws Error unless a file can be made beside `path`. A process that is killed meanwhile leaves
/// nothing where the file system has files without names.
void require_writable_folder(const std::string& path) {
  const Descriptor nameless(
      ::open(folder_of(path).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0600));
  if (nameless.get() < 0) ::unlink(new_file_beside(path).path.c_str());
}

/// After this the new names survive a power cut; some file systems cannot, which is no error.
void sync_folder(const std::string& path) {
  const Descriptor folder(::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() >= 0) ::fsync(folder.get());
}

/// Renames, but not over another file.
/// @return 0, or the system's reason
int rename_to_free_name(const std::string& from, const std::string& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  if (::link(from.c_str(), to.c_str()) != 0) return errno;  // a file system without that call
  ::unlink(from.c_str());
  return 0;
}

}  // namespace

OutputFiles::~OutputFiles() {
  for (const Staged& each : staged_) ::unlink(each.part.c_str());
}

void OutputFiles::check(const std::string& path) const {
  std::error_code ignored;
  const std::string folder = folder_of(path);
  require(!std::filesystem::is_directory(path, ignored),
          path + ": is a folder, the name of a file is needed");
  require(std::filesystem::is_directory(folder, ignored),
          path + ": cannot be written: the folder " + folder + " does not exist");
  require(overwrite_ || !std::filesystem::exists(std::filesystem::symlink_status(path, ignored)),
          path + ": exists already; give another name, or --overwrite to replace it");
  refuse_input(path);
  require_writable_folder(path);
}

void OutputFiles::stage(const std::string& path, std::string_view bytes) {
  NewFile made = new_file_beside(path);
  staged_.push_back({path, made.path});
  while (!bytes.empty()) {
    const ssize_t written = ::write(made.file.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path, "cannot be written, nothing was kept", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fsync(made.file.get()) != 0) fail(path, "cannot be written, nothing was kept", errno);
  if (!made.file.close()) fail(path, "cannot be written, nothing was kept", errno);
}

void OutputFiles::commit() {
  for (const Staged& each : staged_) refuse_input(each.path);
  for (const Staged& each : staged_) {
    std::error_code ignored;
    if (overwrite_ || !std::filesystem::exists(each.path, ignored)) continue;
    throw Error(each.path + ": was created by another process in the meantime and is kept");
  }
  for (; !staged_.empty(); staged_.pop_back())
    put_in_place(staged_.back().part, staged_.back().path, overwrite_);
}

void refuse_input(const std::string& path) {
  require(!was_read(path), path +
                               ": is read by this command and cannot be its output too; give "
                               "another name");
}

void put_in_place(const std::string& made, const std::string& path, bool overwrite) {
  refuse_input(path);
  const Descriptor file(::open(made.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0 || ::fsync(file.get()) != 0) fail(path, "cannot be written", errno);
  const int problem = !overwrite ? rename_to_free_name(made, path)
                      : std::rename(made.c_str(), path.c_str()) == 0 ? 0
                                                                     : errno;
  require(problem != EEXIST || overwrite,
          path + ": was created by another process in the meantime and is kept");
  if (problem != 0) fail(path, "cannot be put in place", problem);
  sync_folder(path);
}

}  // namespace gurney::study
