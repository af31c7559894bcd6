#pragma once

#include <vector>

#include "studies/plan/undrawn_ranges.h"
#include "studies/run/run_task.h"

namespace gurney::study {

/// An assumption of a configuration with every number at its value.
struct StatedAssumption {
  std::size_t configuration = 0;
  equipment::Assumption assumption;
  bool drawn = false;  ///< the study draws it
};

std::vector<StatedAssumption> stated_assumptions(const Batch& batch);

UndrawnRanges undrawn_ranges(const Batch& batch);

}  // namespace gurney::study
