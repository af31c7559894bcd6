#include "studies/run/part_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/input_file.h"
#include "studies/results/output_files.h"
#include "studies/run/identity_file.h"
#include "studies/run/study_identity.h"

namespace gurney::study {
namespace {

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

}  // namespace

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

namespace {

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
  warnings_.push_back(fmt::format("{}: is damaged ({} bytes, {}): its runs are repeated",
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
