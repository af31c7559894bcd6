#pragma once

#include <string>
#include <vector>

#include "studies/analysis/fragility_result.h"
#include "studies/statistics/joint_failure.h"

namespace gurney::study {

/// How likely each performance level is the worst that is reached, at some intensities.
struct PerformanceTable {
  std::string configuration;
  std::vector<std::string> levels;                 ///< limit states, mildest first
  std::vector<double> im;                          ///< SI
  std::vector<statistics::LevelProbabilities> at;  ///< for each im
};

/// From the curves of the study's performance levels; where a level has no curve, from the
/// isotonic fractions of its stripes. None without performance levels, and without stripes.
/// @param results  of one configuration and one measure, of each level among them
std::vector<PerformanceTable> performance_tables(const StudyData& data,
                                                 const std::vector<FragilityResult>& results);

}  // namespace gurney::study
