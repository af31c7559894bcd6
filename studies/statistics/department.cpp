#include "studies/statistics/department.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

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

CombinedProbabilities combine(const std::vector<double>& probabilities) {
  require_probabilities(probabilities);
  CombinedProbabilities result;
  result.number_independent = {1};
  double least = 1, most = 0, none = 1, all = 1;
  for (const double p : probabilities) {
    result.expected_number += p;
    least = std::min(least, p);
    most = std::max(most, p);
    none *= 1 - p;
    all *= p;
    std::vector<double>& number = result.number_independent;
    number.push_back(0);
    for (std::size_t k = number.size() - 1; k > 0; --k)
      number[k] = number[k] * (1 - p) + number[k - 1] * p;
    number[0] *= 1 - p;
  }
  const double n = static_cast<double>(probabilities.size());
  result.any_independent = 1 - none;
  result.all_independent = all;
  result.any = {most, std::min(1.0, result.expected_number)};
  result.all = {std::max(0.0, result.expected_number - (n - 1)), least};
  return result;
}

JointOutcomes joint_outcomes(const std::vector<std::vector<bool>>& failed) {
  require(!failed.empty(), "there are no runs");
  const std::size_t items = failed.front().size();
  const double share = 1 / static_cast<double>(failed.size());
  JointOutcomes result;
  result.number.resize(items + 1);
  std::vector<std::size_t> runs(items + 1);
  for (const std::vector<bool>& run : failed) {
    require(run.size() == items,
            fmt::format("a run has {} items, the first has {}", run.size(), items));
    ++runs[static_cast<std::size_t>(std::count(run.begin(), run.end(), true))];
  }
  for (std::size_t k = 0; k <= items; ++k) {
    result.number[k] = static_cast<double>(runs[k]) * share;
    result.mean_number += static_cast<double>(k) * result.number[k];
  }
  result.any = 1 - result.number.front();
  result.all = result.number.back();
  return result;
}

}  // namespace gurney::statistics
