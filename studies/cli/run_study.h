#pragma once

#include "studies/cli/run_command.h"

namespace gurney::cli {

/// Runs a job with a table [study].
/// @return 0, 3 when some runs failed, 130 or 143 when it was interrupted
/// @throws Error
int run_study(const RunOptions& options);

}  // namespace gurney::cli
