#include "studies/study/run/part_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/input_file.h"
#include "studies/study/results/output_files.h"
#include "studies/study/run/study_identity.h"

namespace gurney::study {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "gurney part 2\n";
constexpr std::size_t kHashLength = 64;
constexpr std::size_t kHeadLength = 16 + kHashLength;  ///< of a task: its number, size and hash

std::string bytes_of(const fs::path& path) {
  return read_input_file(path.string(), std::numeric_limits<std::uintmax_t>::max());
}

void write_whole(const fs::path& path, const std::string& bytes) {
  OutputFiles files(false);
  files.stage(path.string(), bytes);
  files.commit();
}

std::string bytes_of(std::uint64_t number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::uint64_t number_at(std::string_view bytes, std::size_t offset) {
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
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

/// Numbers of the part files, increasing.
std::vector<std::uint32_t> parts_in(const fs::path& folder) {
  std::vector<std::uint32_t> parts;
  for (const std::string& name : own_names(folder))
    if (name.size() == 13 && name.ends_with(".part"))
      parts.push_back(static_cast<std::uint32_t>(std::stoul(name)));
  std::ranges::sort(parts);
  return parts;
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

std::string identity_in(const fs::path& folder) {
  const fs::path study = folder / "study";
  return fs::exists(study) ? bytes_of(study) : std::string();
}

PartFolder::PartFolder(fs::path folder, const std::string& identity, std::size_t tasks, Start start)
    : lock_(std::move(folder)), identity_hash_(sha256(identity)), tasks_(tasks) {
  if (!lock_.warning().empty()) warnings_.push_back(lock_.warning());
  if (start == Start::kReplace) remove_parts(path());
  this->start(identity, start);
  for (const std::uint32_t part : parts_in(path())) {
    next_ = part + 1;
    take_over(part);
  }
}

void PartFolder::start(const std::string& identity, Start start) {
  const std::string theirs = identity_in(path());
  if (!theirs.empty()) {
    require(start == Start::kResume,
            path().string() +
                ": contains runs of an interrupted study; continue with --resume, or start again "
                "with --overwrite");
    require(theirs == identity,
            path().string() + ": contains runs of another study: " + difference(theirs, identity));
    return;
  }
  require(parts_in(path()).empty(), path().string() +
                                        ": contains runs, but no file 'study' that identifies "
                                        "them; start again with --overwrite");
  std::error_code ignored;
  fs::remove(path() / "study", ignored);  // an empty one
  write_whole(path() / "study", identity);
}

fs::path PartFolder::path_of(std::uint32_t part) const {
  return path() / fmt::format("{:08}.part", part);
}

std::string PartFolder::hash_of(std::size_t task, std::string_view bytes) const {
  return sha256(identity_hash_ + bytes_of(task) + std::string(bytes));
}

/// Finds the tasks of a part that is whole. @return what is wrong with it; empty: nothing
std::string PartFolder::damage_of(std::uint32_t part, const std::string& bytes) {
  const std::size_t content = bytes.size() - std::min(bytes.size(), kHashLength);
  const bool whole = bytes.starts_with(kMagic) &&
                     sha256(std::string_view(bytes).substr(0, content)) == bytes.substr(content);
  if (!whole) return "its checksum does not match";
  if (part == 0) return "parts are numbered from 1";
  std::map<std::size_t, Place> found;
  for (std::size_t at = kMagic.size(); at < content;) {
    if (content - at < kHeadLength) return "a unit is cut off";
    const std::uint64_t task = number_at(bytes, at), size = number_at(bytes, at + 8);
    if (size > content - at - kHeadLength) return "a unit is larger than the part";
    if (task >= tasks_) return fmt::format("it has unit {} of {}", task, tasks_);
    const std::string_view task_bytes = std::string_view(bytes).substr(at + kHeadLength, size);
    if (hash_of(task, task_bytes) != bytes.substr(at + 16, kHashLength))
      return fmt::format("its unit {} belongs to another study", task);
    found[task] = {part, at + kHeadLength, size};
    at += kHeadLength + size;
  }
  for (const auto& [task, where] : found) place(task, where);
  return {};
}

void PartFolder::take_over(std::uint32_t part) {
  const fs::path path = path_of(part);
  const std::string bytes = bytes_of(path);
  const std::string damage = damage_of(part, bytes);
  if (damage.empty()) return;
  fs::rename(path, fs::path(path).replace_extension(".damaged"));
  warnings_.push_back(fmt::format("{}: is damaged ({} bytes, {}): its runs are repeated",
                                  path.string(), bytes.size(), damage));
}

void PartFolder::add(const std::map<std::size_t, std::string>& tasks) {
  if (tasks.empty()) return;
  lock_.check();
  std::string bytes(kMagic);
  std::map<std::size_t, Place> places;
  for (const auto& [task, content] : tasks) {
    bytes += bytes_of(task) + bytes_of(content.size()) + hash_of(task, content);
    places[task] = {next_, bytes.size(), content.size()};
    bytes += content;
  }
  bytes += sha256(bytes);
  write_whole(path_of(next_), bytes);
  ++next_;
  for (const auto& [task, where] : places) place(task, where);
}

void PartFolder::place(std::size_t task, const Place& place) {
  if (places_.size() <= task) places_.resize(task + 1);
  if (places_[task].part == 0) ++size_;
  places_[task] = place;
}

std::string PartFolder::read(std::size_t task) const {
  const Place& place = places_.at(task);
  const fs::path path = path_of(place.part);
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(kHeadLength + place.size, '\0');
  stream.seekg(static_cast<std::streamoff>(place.offset - kHeadLength));
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  require(bool(stream), path.string() + ": cannot be read any more");
  const std::string head = bytes_of(task) + bytes_of(place.size);
  const std::string content = bytes.substr(kHeadLength);
  require(bytes.starts_with(head + hash_of(task, content)),
          fmt::format("{}: was changed while the study ran: the checksum of unit {} does not match",
                      path.string(), task));
  return content;
}

void PartFolder::remove() {
  lock_.check();
  remove_parts(path());
}

}  // namespace gurney::study
