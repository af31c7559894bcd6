#include "studies/run/part_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <string_view>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/input_file.h"
#include "studies/results/output_files.h"
#include "studies/run/study_identity.h"

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

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "gurney part 3\n";
constexpr std::size_t kHashLength = 64;
constexpr std::size_t kHeadLength = 16 + kHashLength;  ///< of a task: its number, size and hash
constexpr std::size_t kNameLength = 13;                ///< 00000001.part

std::string bytes_of(std::uint64_t number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::uint64_t number_at(std::string_view bytes, std::size_t offset) {
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

bool is_part_name(const std::string& name) {
  return name.size() == kNameLength && name.ends_with(".part") &&
         name.find_first_not_of("0123456789") == kNameLength - 5;
}

namespace fs = std::filesystem;

void write_whole(const fs::path& path, const std::string& bytes) {
  OutputFiles files(false);
  files.stage(path.string(), bytes);
  files.commit();
}

/// Names that this program gave in the folder.
std::vector<std::string> own_names(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    std::string name = entry.path().filename().string();
    if (is_own_name(name) && !fs::is_directory(entry.symlink_status())) names.push_back(name);
  }
  return names;
}

/// `study` goes last: parts are never without it.
void remove_parts(const fs::path& folder) {
  std::error_code problem;
  for (const std::string& name : own_names(folder))
    if (name != "study" && name != "lock") fs::remove(folder / name, problem);
  fs::remove(folder / "study", problem);
  require(!problem, folder.string() + ": cannot be removed: " + problem.message());
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

PartFormat::PartFormat(const std::string& identity, std::size_t tasks)
    : identity_hash_(sha256(identity)), tasks_(tasks) {}

std::string PartFormat::hash_of(std::size_t task, std::string_view bytes) const {
  return sha256(identity_hash_ + bytes_of(task) + std::string(bytes));
}

std::string PartFormat::encode(const TaskBytes& tasks, std::vector<PartEntry>& entries) const {
  std::size_t size = kMagic.size() + kHashLength;
  for (const auto& [task, content] : tasks) size += kHeadLength + content.size();
  std::string bytes;
  bytes.reserve(size);  // up to 8 MB, which a buffer that doubles would hold twice
  bytes += kMagic;
  for (const auto& [task, content] : tasks) {
    bytes += bytes_of(task) + bytes_of(content.size()) + hash_of(task, content);
    entries.push_back({task, bytes.size(), content.size()});
    bytes += content;
  }
  bytes += sha256(bytes);
  return bytes;
}

PartContent PartFormat::decode(std::string_view bytes) const {
  const std::size_t content = bytes.size() - std::min(bytes.size(), kHashLength);
  const bool whole =
      bytes.starts_with(kMagic) && sha256(bytes.substr(0, content)) == bytes.substr(content);
  if (!whole) return {{}, "its checksum does not match"};
  PartContent part;
  for (std::size_t at = kMagic.size(); at < content;) {
    if (content - at < kHeadLength) return {{}, "an analysis case is cut off"};
    const std::uint64_t task = number_at(bytes, at), size = number_at(bytes, at + 8);
    if (size > content - at - kHeadLength) return {{}, "an analysis case is larger than the part"};
    if (task >= tasks_) return {{}, fmt::format("it has analysis case {} of {}", task, tasks_)};
    if (hash_of(task, bytes.substr(at + kHeadLength, size)) != bytes.substr(at + 16, kHashLength))
      return {{}, fmt::format("its analysis case {} belongs to another study", task), true};
    part.entries.push_back({task, at + kHeadLength, size});
    at += kHeadLength + size;
  }
  return part;
}

std::string PartFormat::read(const fs::path& file, const PartEntry& entry) const {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(kHeadLength + entry.size, '\0');
  stream.seekg(static_cast<std::streamoff>(entry.offset - kHeadLength));
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  require(bool(stream), file.string() + ": cannot be read any more");
  const std::string head = bytes_of(entry.task) + bytes_of(entry.size);
  const std::string content = bytes.substr(kHeadLength);
  require(bytes.starts_with(head + hash_of(entry.task, content)),
          fmt::format("{}: was changed while the study ran: the checksum of analysis case {} does "
                      "not match",
                      file.string(), entry.task));
  return content;
}

fs::path part_path(const fs::path& folder, std::uint32_t part) {
  return folder / fmt::format("{:08}.part", part);
}

std::vector<std::uint32_t> part_numbers(const fs::path& folder) {
  std::vector<std::uint32_t> parts;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (is_part_name(name) && !fs::is_directory(entry.symlink_status()))
      parts.push_back(static_cast<std::uint32_t>(std::stoul(name)));
  }
  std::ranges::sort(parts);
  return parts;
}

std::string file_bytes(const fs::path& path) {
  return read_input_file(path.string(), std::numeric_limits<std::uintmax_t>::max());
}

PartFolder::PartFolder(fs::path folder, const std::string& identity, std::size_t tasks, Start start,
                       const Shard& shard)
    : lock_(std::move(folder)), format_(identity, tasks), shard_(shard) {
  if (!lock_.warning().empty()) warnings_.push_back(lock_.warning());
  if (start == Start::kReplace) remove_parts(path());
  this->start(identity, start);
  for (const std::uint32_t part : part_numbers(path())) {
    next_ = part + 1;
    take_over(part);
  }
}

void PartFolder::start(const std::string& identity, Start start) {
  const IdentityFile study(path());
  const std::vector<std::uint32_t> parts = part_numbers(path());
  if (study.exists() || !parts.empty()) {
    require(start == Start::kResume,
            path().string() +
                ": contains runs of an interrupted study; continue with --resume, or start again "
                "with --overwrite");
    if (study.exists() && !study.damaged()) {
      require(study.identity() == identity, path().string() + ": contains runs of another study: " +
                                                difference(study.identity(), identity));
      return;
    }
    restore(study.exists() ? "is damaged" : "is missing", parts);
  }
  std::error_code ignored;
  fs::remove(path() / "study", ignored);  // a damaged or empty one
  write_whole(path() / "study", IdentityFile::bytes_of(identity));
}

void PartFolder::restore(const std::string& problem, const std::vector<std::uint32_t>& parts) {
  const std::string what = (path() / "study").string() + ": " + problem;
  const auto foreign = std::ranges::find_if(parts, [&](std::uint32_t part) {
    return format_.decode(file_bytes(part_path(path(), part))).foreign;
  });
  if (foreign != parts.end())
    throw Error(
        fmt::format("{}, and {} beside it belongs to another study, or to this one as another "
                    "program ran it; start again with --overwrite",
                    what, part_path({}, *foreign).string()));
  warnings_.push_back(what + "; it is written again: no part beside it belongs to another study");
}

void PartFolder::take_over(std::uint32_t part) {
  const fs::path path = part_path(this->path(), part);
  const std::string bytes = file_bytes(path);
  PartContent content = format_.decode(bytes);
  if (part == 0) content = {{}, "parts are numbered from 1"};
  for (const PartEntry& entry : content.entries) place(part, entry);
  if (content.damage.empty()) return;
  fs::rename(path, fs::path(path).replace_extension(".damaged"));
  warnings_.push_back(fmt::format("{}: is damaged ({} bytes, {}): its runs are missing",
                                  path.string(), bytes.size(), content.damage));
}

void PartFolder::add(const TaskBytes& tasks) {
  if (tasks.empty()) return;
  lock_.check();
  std::vector<PartEntry> entries;
  write_whole(part_path(path(), next_), format_.encode(tasks, entries));
  for (const PartEntry& entry : entries) place(next_, entry);
  ++next_;
}

void PartFolder::place(std::uint32_t part, const PartEntry& entry) {
  if (!shard_.has(entry.task)) return;
  const std::size_t index = index_of(entry.task);
  if (places_.size() <= index) places_.resize(index + 1);
  if (places_[index].part == 0) ++size_;
  places_[index] = {part, entry};
}

std::string PartFolder::read(std::size_t task) const {
  const Place& place = places_.at(index_of(task));
  return format_.read(part_path(path(), place.part), place.entry);
}

void PartFolder::remove() {
  lock_.check();
  remove_parts(path());
}

}  // namespace gurney::study
