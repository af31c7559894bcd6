#pragma once

#include <cstddef>
#include <vector>

#include "studies/statistics/bands.h"

namespace gurney::statistics {

/// P(the level is the worst reached) from P(level or worse) of ordered levels at one im.
struct LevelProbabilities {
  std::vector<double> of_level;  ///< none first, then each level; sums to 1
  bool crossed = false;  ///< a worse level was more likely than a better one and was cut to it
};

/// @param exceedance  P(level or worse), mildest level first
/// @throws Error unless all are within [0, 1].
LevelProbabilities level_probabilities(const std::vector<double>& exceedance);

/// Several items that may fail, from the probability of each: what independence gives, and the
/// bounds that hold whatever the dependence (Frechet 1935, Fundamenta Mathematicae 25, 379-387).
struct CombinedProbabilities {
  double expected_number = 0;  ///< whatever the dependence
  double any_independent = 0, all_independent = 0;
  Interval any;                            ///< low: the items fail together; high: one at a time
  Interval all;                            ///< high: the items fail together
  std::vector<double> number_independent;  ///< P(exactly k fail), k = 0 to n
};

/// @throws Error unless all are within [0, 1].
CombinedProbabilities combine(const std::vector<double>& probabilities);

/// The same straight from runs in which all the items stood: dependence is in the counts.
struct JointOutcomes {
  double mean_number = 0;
  double any = 0, all = 0;     ///< fractions of the runs
  std::vector<double> number;  ///< fraction of the runs where exactly k failed, k = 0 to n
};

/// @param failed  one row for each run, one entry for each item
/// @throws Error unless there is a run and all rows are equally long.
JointOutcomes joint_outcomes(const std::vector<std::vector<bool>>& failed);

}  // namespace gurney::statistics
