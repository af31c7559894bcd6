#include "studies/run/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "engine/base/error.h"

namespace gurney::study {
namespace {

namespace fs = std::filesystem;

/// A name in the folder that this program did not give; empty: there is none.
std::string foreign_name(const fs::path& folder) {
  std::error_code gone;  // by another process
  for (const auto& entry : fs::directory_iterator(folder, gone))
    if (!is_own_name(entry.path().filename().string())) return entry.path().filename().string();
  return {};
}

void make(const fs::path& folder) {
  std::error_code problem;
  fs::create_directory(folder, problem);
  require(!problem, folder.string() + ": cannot be created: " + problem.message());
  require(!fs::is_symlink(folder, problem),
          folder.string() + ": is a link; a folder is needed, which is removed at the end");
  if (fs::exists(folder / "study", problem)) return;
  const std::string foreign = foreign_name(folder);
  require(foreign.empty(), folder.string() + ": is not a folder of parts, it contains '" + foreign +
                               "'; it is kept. Give another name with -o");
}

/// Name that the holder wrote into the lock.
std::string holder(int file) {
  std::array<char, 300> bytes{};
  const ssize_t size = ::pread(file, bytes.data(), bytes.size(), 0);
  const std::string text(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(0, size)));
  return text.substr(0, text.find('\n'));
}

void write_holder(int file) {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  const std::string text = fmt::format("process {} on {}\n", ::getpid(), host.data());
  if (::ftruncate(file, 0) != 0) return;
  [[maybe_unused]] const auto ignored = ::pwrite(file, text.data(), text.size(), 0);
}

/// @returns errno; 0: it is locked
int lock(int file, int kind) {
  constexpr int kTries = 5;  // working_process() of others holds it for microseconds
  for (int i = 1;; ++i) {
    if (::flock(file, kind | LOCK_NB) == 0) return 0;
    if (errno != EWOULDBLOCK || i == kTries) return errno;
    ::usleep(20000);
  }
}

bool all_digits(std::string_view text) {
  return text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

bool is_own_name(const std::string& name) {
  if (name == "lock" || name == "study" || name == "crashes" || name == "results.h5") return true;
  if (name.starts_with("study.part") || name == "job" || name == "job.part") return true;
  return name.size() >= 13 && all_digits(std::string_view(name).substr(0, 8)) &&
         (name.substr(8) == ".damaged" || name.substr(8).starts_with(".part"));
}

std::string working_process(const fs::path& folder) {
  const int file = ::open((folder / "lock").c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return {};
  const bool works = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  std::string process = works ? holder(file) : std::string();
  if (works && process.empty()) process = "a process";
  ::close(file);
  return process;
}

void remove_abandoned(const fs::path& folder) {
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem))
    if (entry.path().filename() != "lock") return;
  if (!problem && working_process(folder).empty()) const FolderLock taken(folder);
}

FolderLock::FolderLock(fs::path folder) : folder_(std::move(folder)), file_(folder_ / "lock") {
  constexpr int kTries = 100;  // each fails only because another process removed the folder
  for (int i = 0; i < kTries; ++i) {
    make(folder_);
    if (try_lock()) return;
  }
  throw Error(folder_.string() + ": cannot be locked, other processes make and remove it");
}

bool FolderLock::try_lock() {
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor_ < 0 && errno == ENOENT) return false;
  require(descriptor_ >= 0, file_.string() + ": cannot be opened: " + std::strerror(errno));
  const int problem = lock(descriptor_, LOCK_EX);
  if (problem == EWOULDBLOCK) {
    const std::string other = holder(descriptor_);
    ::close(descriptor_);
    throw Error(fmt::format("{}: another process works on this study{}{}", folder_.string(),
                            other.empty() ? "" : ": ", other));
  }
  if (problem != 0)
    warning_ = fmt::format("{}: cannot be locked ({}); let no other process work on this study",
                           folder_.string(), std::strerror(problem));
  if (holds()) {
    write_holder(descriptor_);
    return true;
  }
  ::close(descriptor_);
  return false;
}

bool FolderLock::holds() const {
  struct stat ours {
  }, there{};
  return ::fstat(descriptor_, &ours) == 0 && ::lstat(file_.c_str(), &there) == 0 &&
         ours.st_ino == there.st_ino && ours.st_dev == there.st_dev;
}

void FolderLock::check() const {
  require(holds(), folder_.string() + ": was removed while the study ran");
}

FolderLock::~FolderLock() {
  std::error_code ignored;
  if (holds() && !fs::exists(folder_ / "study", ignored)) {
    ::unlink(file_.c_str());
    ::rmdir(folder_.c_str());
  }
  ::close(descriptor_);
}

}  // namespace gurney::study
