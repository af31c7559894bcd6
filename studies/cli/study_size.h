#pragma once

#include <string>

#include "studies/run/run_task.h"

namespace gurney::cli {

/// Runs that a study may have: 10 million take 28 hours on one core at 10 ms each, and 1 GB of
/// memory for their bookkeeping at most.
inline constexpr double kMaxRuns = 1e7;

std::string duration_text(double seconds);

/// "a second", "20 s", "a minute", "3 min": an estimate, as well as it is known.
std::string rounded_duration(double seconds);
std::string size_text(double bytes);

/// @throws Error for a study with more runs than kMaxRuns, with what it would take
void refuse_oversized(const study::Batch& batch);

}  // namespace gurney::cli
