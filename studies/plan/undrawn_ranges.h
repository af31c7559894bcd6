#pragma once

#include <string>
#include <vector>

namespace gurney::study {

/// Parameters with a declared range that a study leaves at their values, by data file.
class UndrawnRanges {
 public:
  /// Indices and axes are one parameter: `shape[1].size_mm.x` is `shape[].size_mm`.
  void add(const std::string& file, const std::string& key);

  /// `R100.toml: wheel_mass_kg, fork_mass_kg` for each file.
  std::vector<std::string> lines() const;

  std::size_t parameters() const;

 private:
  struct OfFile {
    std::string name;
    std::vector<std::string> parameters;
  };
  std::vector<OfFile> files_;
};

}  // namespace gurney::study
