#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gurney::study {

/// Bytes of tasks, by their indices.
using TaskBytes = std::map<std::size_t, std::string>;

/// Where the bytes of a task are in a part file.
struct PartEntry {
  std::size_t task = 0;
  std::uint64_t offset = 0, size = 0;
};

/// What a part file holds: whole tasks, each with a SHA-256 that binds it to its study and its
/// number, and at the end the SHA-256 of all before.
struct PartContent {
  std::vector<PartEntry> entries;
  std::string damage;    ///< why it cannot be used; empty: nothing
  bool foreign = false;  ///< it is whole, and of another study
};

/// Those of one study.
/// @param identity  of the study (study_identity.h)
/// @param tasks     their number
class PartFormat {
 public:
  PartFormat(const std::string& identity, std::size_t tasks);

  std::string encode(const TaskBytes& tasks, std::vector<PartEntry>& entries) const;
  PartContent decode(std::string_view bytes) const;

  /// The bytes of one task.
  /// @throws Error unless they are those that were encoded
  std::string read(const std::filesystem::path& file, const PartEntry& entry) const;

 private:
  std::string hash_of(std::size_t task, std::string_view bytes) const;

  std::string identity_hash_;
  std::size_t tasks_;
};

std::filesystem::path part_path(const std::filesystem::path& folder, std::uint32_t part);

/// Numbers of the part files of a folder, increasing.
std::vector<std::uint32_t> part_numbers(const std::filesystem::path& folder);

/// The bytes of a file that this program wrote.
std::string file_bytes(const std::filesystem::path& path);

}  // namespace gurney::study
