#pragma once

#include <vector>

namespace gurney::statistics {

/// P(the level is the worst reached) from P(level or worse) of ordered levels at one im.
struct LevelProbabilities {
  std::vector<double> of_level;  ///< none first, then each level; sums to 1
  bool crossed = false;  ///< a worse level was more likely than a better one and was cut to it
};

/// @param exceedance  P(level or worse), mildest level first
/// @throws Error unless all are within [0, 1].
LevelProbabilities level_probabilities(const std::vector<double>& exceedance);

}  // namespace gurney::statistics
