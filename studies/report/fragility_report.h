#pragma once

#include <string>
#include <vector>

#include "studies/analysis/fragility_result.h"

namespace gurney {

/// A unit to tell intensities in.
struct IntensityUnit {
  std::string name;
  double in_si = 1;
};

/// The unit the study states its levels in where it is their measure; else g, m/s, m or s.
IntensityUnit unit_to_tell(const StudyData& data, const RunMeasure& measure);

/// A table with a row for each configuration and limit state, and below what to know of them.
std::string fragility_report(const StudyData& data, const std::vector<FragilityResult>& results);

/// The same for machines, in SI; no curve: null.
std::string fragility_json(const std::vector<FragilityResult>& results);

/// One panel for each limit state: the curves of its configurations, their bands, and the fractions
/// of runs.
std::string fragility_figure(const StudyData& data, const std::vector<FragilityResult>& results);

}  // namespace gurney
