#include "studies/statistics/joint_failure.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"

namespace gurney::statistics {
namespace {

void require_probabilities(const std::vector<double>& probabilities) {
  for (std::size_t i = 0; i < probabilities.size(); ++i)
    require(probabilities[i] >= 0 && probabilities[i] <= 1,
            fmt::format("probability[{}] = {:g} must be within [0, 1]", i, probabilities[i]));
}

}  // namespace

LevelProbabilities level_probabilities(const std::vector<double>& exceedance) {
  require_probabilities(exceedance);
  LevelProbabilities result;
  double better = 1;
  for (const double probability : exceedance) {
    result.crossed = result.crossed || probability > better;
    const double here = std::min(better, probability);
    result.of_level.push_back(better - here);
    better = here;
  }
  result.of_level.push_back(better);
  return result;
}

}  // namespace gurney::statistics
