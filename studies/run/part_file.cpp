#include "studies/run/part_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/input_file.h"

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

}  // namespace gurney::study
