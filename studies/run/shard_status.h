#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "studies/run/part_folder.h"
#include "studies/run/shard.h"
#include "studies/run/task_result.h"

namespace gurney::study {

/// CPU time of the runs under one record.
struct RecordTime {
  std::size_t runs = 0;
  double seconds = 0;  ///< CPU time of all

  double mean() const { return runs == 0 ? 0 : seconds / static_cast<double>(runs); }
};

/// Finished cases of a shard, read beside the process that works on it.
struct ShardStatus {
  Shard shard = {};
  std::size_t tasks = 0, done = 0;  ///< analysis cases
  RunCounts counts = {};
  std::size_t damaged = 0;      ///< part files whose runs will be repeated
  std::size_t foreign = 0;      ///< analysis cases in its folder that are not its own
  std::size_t stages = 1;       ///< of the study
  std::size_t stage = 0;        ///< that it ended with and the next waits for; 0: within one
  bool other_study = false;     ///< most shards beside it are of another study: nothing is counted
  bool started = false;         ///< it has a folder
  std::string process = {};     ///< that works on it: "process 12 on node3"; empty: none
  double runs_per_second = 0;   ///< of the last attempt, up to its last part; 0: unknown
  double seconds_per_task = 0;  ///< the same
  std::map<std::string, RecordTime> records = {};  ///< by name; empty: the floor is at rest
};

/// All shards of a study. Those of several counts have analysis cases in common.
struct StudyStatus {
  std::vector<ShardStatus> shards = {};
  std::size_t tasks = 0, done = 0;  ///< analysis cases of the study, each counted once
  RunCounts counts = {};            ///< of these
};

/// Reads a folder FILE.h5.shards with those that have not started, or of one FILE.h5.parts as shard
/// 1 of 1. Reads the parts alone and changes nothing.
/// @throws Error for a folder that is neither
StudyStatus study_status(const std::filesystem::path& folder);

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
