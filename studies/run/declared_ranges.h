#pragma once

#include <optional>
#include <vector>

#include "studies/plan/undrawn_ranges.h"
#include "studies/run/run_task.h"

namespace gurney::study {

/// A job of a configuration in one of its draws.
struct DrawnJob {
  std::optional<std::size_t> draw;  ///< none: every number has its value
  Job job;
};

/// The first draw that makes a job (in some, items may overlap); without such a draw, or where
/// nothing is drawn, every number at its value.
DrawnJob first_job(const Batch& batch, std::size_t configuration);

/// An assumption of a configuration with every number at its value.
struct StatedAssumption {
  std::size_t configuration = 0;
  equipment::Assumption assumption;
  bool drawn = false;  ///< the study draws it
};

std::vector<StatedAssumption> stated_assumptions(const Batch& batch);

UndrawnRanges undrawn_ranges(const Batch& batch);

}  // namespace gurney::study
