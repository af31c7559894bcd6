#include "studies/batch/part_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "studies/results/output_files.h"

namespace gurney {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "gurney part 1\n";
constexpr std::size_t kHashLength = 64;

std::string bytes_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  require(stream.is_open(), path.string() + ": cannot be read");
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return std::move(bytes).str();
}

void write_whole(const fs::path& path, const std::string& bytes) {
  OutputFiles files(true);
  files.stage(path.string(), bytes);
  files.commit();
}

void append(std::string& bytes, std::uint64_t number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::uint64_t number_at(const std::string& bytes, std::size_t offset) {
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

/// Numbers of the part files, increasing.
std::vector<std::uint32_t> parts_in(const fs::path& folder) {
  std::vector<std::uint32_t> parts;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool part =
        name.size() == 13 && name.ends_with(".part") && name.find_first_not_of("0123456789") == 8;
    if (part) parts.push_back(static_cast<std::uint32_t>(std::stoul(name)));
  }
  std::ranges::sort(parts);
  return parts;
}

}  // namespace

std::string first_difference(const std::string& theirs, const std::string& ours) {
  std::istringstream a(theirs), b(ours);
  std::string line_a, line_b;
  while (true) {
    const bool more_a = bool(std::getline(a, line_a)), more_b = bool(std::getline(b, line_b));
    if (!more_a && !more_b) return "the last line";
    if (!more_a) line_a.clear();
    if (!more_b) line_b.clear();
    if (line_a != line_b) return fmt::format("there '{}', here '{}'", line_a, line_b);
  }
}

PartFolder::PartFolder(fs::path folder, const std::string& identity, bool resume)
    : folder_(std::move(folder)) {
  const fs::path study = folder_ / "study";
  std::error_code problem;
  if (fs::exists(study, problem)) {
    require(resume, folder_.string() +
                        ": holds runs of a study that was interrupted; go on with --resume, or "
                        "remove this folder to start again");
    const std::string theirs = bytes_of(study);
    require(theirs == identity, folder_.string() + ": holds runs of another study: " +
                                    first_difference(theirs, identity));
  } else {
    fs::create_directory(folder_, problem);
    require(!problem, folder_.string() + ": cannot be made: " + problem.message());
    require(parts_in(folder_).empty(),
            folder_.string() +
                ": holds runs, but no file 'study' that says whose; remove this "
                "folder to start again");
    write_whole(study, identity);
  }
  lock();
  for (const std::uint32_t part : parts_in(folder_)) {
    next_ = part + 1;
    take_over(part);
  }
}

PartFolder::~PartFolder() {
  if (lock_ >= 0) ::close(lock_);
}

void PartFolder::lock() {
  lock_ = ::open((folder_ / "study").c_str(), O_RDONLY | O_CLOEXEC);
  const bool taken = lock_ >= 0 && ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (taken) ::close(lock_);  // no object is left for the destructor
  require(!taken, folder_.string() + ": another process works on this study");
}

fs::path PartFolder::path_of(std::uint32_t part) const {
  return folder_ / fmt::format("{:08}.part", part);
}

void PartFolder::take_over(std::uint32_t part) {
  const fs::path path = path_of(part);
  const std::string bytes = bytes_of(path);
  const std::size_t content = bytes.size() - std::min(bytes.size(), kHashLength);
  const bool whole = bytes.starts_with(kMagic) &&
                     sha256(std::string_view(bytes).substr(0, content)) == bytes.substr(content);
  if (!whole) {
    fs::rename(path, fs::path(path).replace_extension(".damaged"));
    warnings_.push_back(fmt::format(
        "{}: is damaged ({} bytes, its checksum does not match): its runs are made again",
        path.string(), bytes.size()));
    return;
  }
  for (std::size_t at = kMagic.size(); at < content;) {
    const std::uint64_t unit = number_at(bytes, at), size = number_at(bytes, at + 8);
    place(unit, {part, at + 16, size});
    at += 16 + size;
  }
}

void PartFolder::add(const std::map<std::size_t, std::string>& units) {
  if (units.empty()) return;
  std::string bytes(kMagic);
  std::map<std::size_t, Place> places;
  for (const auto& [unit, content] : units) {
    append(bytes, unit);
    append(bytes, content.size());
    places[unit] = {next_, bytes.size(), content.size()};
    bytes += content;
  }
  bytes += sha256(bytes);
  write_whole(path_of(next_), bytes);
  ++next_;
  for (const auto& [unit, where] : places) place(unit, where);
}

void PartFolder::place(std::size_t unit, const Place& place) {
  if (places_.size() <= unit) places_.resize(unit + 1);
  if (places_[unit].part == 0) ++size_;
  places_[unit] = place;
}

std::string PartFolder::read(std::size_t unit) const {
  const Place& place = places_.at(unit);
  const fs::path path = path_of(place.part);
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(place.size, '\0');
  stream.seekg(static_cast<std::streamoff>(place.offset));
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  require(bool(stream), path.string() + ": cannot be read any more");
  return bytes;
}

void PartFolder::remove() {
  std::error_code problem;
  for (const std::uint32_t part : parts_in(folder_)) fs::remove(path_of(part), problem);
  fs::remove_all(folder_, problem);  // `study` goes last: parts are never without it
  require(!problem, folder_.string() + ": cannot be removed: " + problem.message());
}

}  // namespace gurney
