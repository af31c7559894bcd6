#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/response/response.h"

namespace gurney::study {

/// One finished run of a study.
struct StudyRun {
  double scale = 1;      ///< factor on the ground motion
  double intensity = 0;  ///< the study's measure of it [SI]; of scales: 0
  double pfa = 0;        ///< peak horizontal resultant of the floor's acceleration [m/s2]
  double pfv = 0;        ///< and velocity [m/s]
  bool until = false;    ///< it exceeds IntensityPlan::until
  std::vector<std::string> warnings;  ///< of the building, and of a repeat that failed
  Response response;                  ///< histories only where the study keeps them
  /// Demands of the items of a run repeated at half the step; else empty.
  std::vector<Demands> at_half_step;
};

/// Cost of a task of run_batch(). Parts alone have it: results must not depend on the machine.
struct TaskCost {
  std::string record;         ///< name of its ground motion
  double cpu_seconds = 0;     ///< of its thread
  std::uint64_t attempt = 0;  ///< number of the first part of its attempt
  double ended = 0;           ///< time since the attempt began [s], of a clock that nobody sets
};

/// A finished task: its runs in the order they were made.
struct TaskResult {
  std::size_t task = 0;
  std::vector<double> drawn;  ///< as drawn_variables() of its job
  std::vector<StudyRun> runs;
  TaskCost cost;
};

/// Runs by how they ended.
struct RunCounts {
  std::size_t runs = 0, failed = 0, untrusted = 0, overturned = 0;

  void add(const TaskResult& result);
};

std::string to_bytes(TaskResult& result);

/// @throws Error for bytes that to_bytes() did not make
TaskResult task_from_bytes(std::string_view bytes);

}  // namespace gurney::study
