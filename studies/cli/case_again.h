#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "engine/response/response.h"
#include "studies/prepare/run_job.h"

namespace gurney::cli {

/// Whether an HDF5 file holds a study. @throws Error unless it is one
bool is_study(const std::string& path);

/// The run of a results file, to be run again: the one of a single run, or one of a study.
struct CaseAgain {
  study::PreparedRun run;
  /// What differs from the demands in the file, and what may be why; empty: nothing.
  std::function<std::string(const Response&)> difference;
};

/// @param index  the run of a study; of a single run none or 0
/// @param job  the job's file; empty: where the log beside the file says it was
/// @throws Error where the file has no such run, or the job is not that of the file
CaseAgain case_again(const std::string& file, std::optional<std::size_t> index,
                     const std::string& job);

}  // namespace gurney::cli
