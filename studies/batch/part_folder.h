#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace gurney {

/// The first line in which two texts differ: `there 'theirs', here 'ours'`.
std::string first_difference(const std::string& theirs, const std::string& ours);

/// The finished units of a study that is not complete: a folder beside its results file.
///
/// A part file holds whole units and ends with the SHA-256 of all before. It is written under
/// another name, synced and renamed, so that a killed process loses only units it had not reported.
/// The file `study` says whose parts these are, and is locked while a process works on them.
class PartFolder {
 public:
  /// Opens a folder, or makes it.
  /// @param identity  lines `key value`: what must be equal for units to belong together
  /// @param resume    false: there must be no folder yet
  /// @throws Error for a folder that is there without `resume`, for parts of another study (with
  ///         both values), while another process has it, and where nothing can be written. Damaged
  ///         parts are renamed to
  ///         `.damaged` and told in warnings(): their units are not done.
  PartFolder(std::filesystem::path folder, const std::string& identity, bool resume);
  ~PartFolder();
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;

  const std::filesystem::path& path() const { return folder_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  bool has(std::size_t unit) const { return unit < places_.size() && places_[unit].part > 0; }
  std::size_t size() const { return size_; }

  /// Writes a part of these units, in any order.
  /// @param units  by index: the bytes of each
  /// @throws Error with the system's reason, such as a full disk: then none of them counts
  void add(const std::map<std::size_t, std::string>& units);

  /// The bytes of a unit.
  std::string read(std::size_t unit) const;

  /// Removes the folder with all parts.
  void remove();

 private:
  struct Place {
    std::uint32_t part = 0;  ///< from 1; 0: the unit is not done
    std::uint64_t offset = 0, size = 0;
  };
  std::filesystem::path path_of(std::uint32_t part) const;
  void lock();
  void take_over(std::uint32_t part);
  void place(std::size_t unit, const Place& place);

  std::filesystem::path folder_;
  int lock_ = -1;  ///< descriptor of the file `study`
  std::uint32_t next_ = 1;
  std::size_t size_ = 0;
  std::vector<Place> places_;  ///< by unit
  std::vector<std::string> warnings_;
};

}  // namespace gurney
