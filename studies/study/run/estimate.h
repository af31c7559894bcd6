#pragma once

#include <cstddef>

#include "studies/study/run/run_task.h"

namespace gurney::study {

/// What a study will need, from two of its runs.
struct Estimate {
  std::size_t runs = 0;          ///< of an IDA: the most there can be
  double seconds_per_run = 0;    ///< of one thread
  double bytes_per_run = 0;      ///< in part files; the results file needs about as much or less
  std::size_t memory_bytes = 0;  ///< of this process, after these runs

  double bytes() const { return static_cast<double>(runs) * bytes_per_run; }
  double seconds(int threads) const {
    return static_cast<double>(runs) * seconds_per_run / threads;
  }
};

/// Makes the first task's run at its lowest intensity and the last one's at its highest (of an IDA:
/// after three steps), and keeps nothing of them.
/// @throws Error for a draw that makes no job
Estimate estimate(const Batch& batch);

}  // namespace gurney::study
