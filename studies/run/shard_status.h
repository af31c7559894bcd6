#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "studies/run/shard.h"
#include "studies/run/task_result.h"

namespace gurney::study {

/// What the runs under one record took.
struct RecordTime {
  std::size_t runs = 0;
  double seconds = 0;  ///< CPU time of all

  double mean() const { return runs == 0 ? 0 : seconds / static_cast<double>(runs); }
};

/// What a shard has finished, read beside the process that works on it.
struct ShardStatus {
  Shard shard = {};
  std::size_t tasks = 0, done = 0;  ///< analysis cases
  RunCounts counts = {};
  std::size_t damaged = 0;      ///< part files whose runs will be repeated
  std::size_t foreign = 0;      ///< analysis cases in its folder that are not its own
  bool other_study = false;     ///< most shards beside it are of another study: nothing is counted
  bool started = false;         ///< it has a folder
  std::string process = {};     ///< that works on it: "process 12 on node3"; empty: none
  double runs_per_second = 0;   ///< of the last attempt, up to its last part; 0: unknown
  double seconds_per_task = 0;  ///< the same
  std::map<std::string, RecordTime> records = {};  ///< by name; empty: the floor is at rest
};

/// Of a folder FILE.h5.shards with those that have not started, or of one FILE.h5.parts as shard 1
/// of 1. Reads the parts alone and changes nothing.
/// @throws Error for a folder that is neither
std::vector<ShardStatus> shard_status(const std::filesystem::path& folder);

}  // namespace gurney::study
