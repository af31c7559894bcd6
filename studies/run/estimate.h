#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "studies/run/run_task.h"

namespace gurney::study {

/// Needs of a study, from some of its runs.
struct Estimate {
  std::size_t runs = 0;          ///< of an IDA: the most there can be
  std::size_t timed = 0;         ///< runs that were timed
  double seconds_per_run = 0;    ///< of one thread that has a core to itself
  double bytes_per_run = 0;      ///< in part files; the results file needs about as much or less
  std::size_t memory_bytes = 0;  ///< of this process, after these runs
  std::vector<std::string> warnings;  ///< of the building under the motions of these runs

  double bytes() const { return static_cast<double>(runs) * bytes_per_run; }
  double seconds(int threads) const {
    return static_cast<double>(runs) * seconds_per_run / threads;
  }
};

/// Makes up to eight runs, spread over the tasks and their intensities (of an IDA: up to three
/// steps on), until they have taken two seconds, and keeps nothing of them. The first is made
/// twice: what is read and allocated once is not timed. Time is that of the processor, so that what
/// else runs on the machine is not in it.
/// @throws Error for a draw that makes no job
Estimate estimate(const Batch& batch);

}  // namespace gurney::study
