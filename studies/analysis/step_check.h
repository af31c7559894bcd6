#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/study_data.h"
#include "studies/statistics/two_groups.h"

namespace gurney::study {

/// How much a demand changes where the time step is halved.
struct StepChange {
  std::string demand;
  std::string point;         ///< the marked point whose demand it is; empty: of the item
  std::size_t compared = 0;  ///< items of runs that have the demand at both steps

  /// Quantile of the sizes of relative_change() (engine/response/settled.h).
  double median = 0, largest = 0;
  double within_1_percent = 0, within_5_percent = 0;  ///< shares of those compared
  std::size_t largest_run = 0;
};

/// Runs whose outcome at a limit state is another one at half the step.
struct StateChange {
  std::string state;
  std::vector<std::size_t> runs;
};

/// A demand or a limit state of chaotic runs at both steps, paired by record: a is the step, b half
/// of it.
struct StepDistribution {
  std::string name;
  statistics::PairedDifference of;
};

/// Runs of chaotic cases (in_chaotic_cases()). No step gives them a number, so distributions are
/// compared.
struct ChaoticStepCheck {
  std::size_t runs = 0;
  std::vector<StepDistribution> demands;  ///< of ln demand: exp(difference) is a ratio of medians
                                          ///< where demands are lognormal; demands > 0 only
  std::vector<StepDistribution> states;   ///< of 1 where exceeded, else 0: a difference of P
};

/// Evidence of the runs repeated with half the time step on the others.
struct StepCheck {
  std::size_t runs = 0;                     ///< that were repeated
  std::size_t failed = 0;                   ///< whose repetition failed
  std::optional<ChaoticStepCheck> chaotic;  ///< where there are such runs; the rest leaves them out
  std::vector<StepChange> changes;
  std::vector<StateChange> states;    ///< those that ask for demands of items and points only
  std::vector<std::string> unjudged;  ///< the others: the repetition keeps no more
};

/// "peak_tilt", or of a point "monitor: peak_displacement".
std::string name_of(const StepChange& change);

/// None where the study asked for no step_check.
std::optional<StepCheck> step_check(const StudyData& data);

}  // namespace gurney::study
