#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/run/part_file.h"
#include "studies/run/task_result.h"

namespace gurney::study {

/// The analysis cases that a study has finished so far, read beside the process that works on it:
/// of a folder FILE.h5.parts, or of all shards of FILE.h5.shards. Changes nothing.
class FinishedCases {
 public:
  /// @throws Error for a folder that is neither
  explicit FinishedCases(const std::filesystem::path& folder);

  const std::string& identity() const { return identity_; }
  std::size_t tasks() const { return places_.size(); }
  std::size_t finished() const { return finished_; }
  std::size_t damaged() const { return damaged_; }  ///< part files that are left out
  bool has(std::size_t task) const { return !places_[task].file.empty(); }
  TaskResult read(std::size_t task) const;

  /// Writes those cases as the results file of a study.
  /// @param job  path of the job's file, for relative names
  /// @throws Error where the job, its records or its data files are no longer those of the study,
  ///         or the program is another
  void write(const std::string& path, const std::string& job) const;

 private:
  struct Place {
    std::filesystem::path file;  ///< empty: not finished
    PartEntry entry;
  };
  void take(const std::filesystem::path& folder);

  std::string identity_;
  std::vector<Place> places_;  ///< by task
  std::size_t finished_ = 0, damaged_ = 0;
};

}  // namespace gurney::study
