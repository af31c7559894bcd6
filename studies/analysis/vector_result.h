#pragma once

#include <array>
#include <string>
#include <vector>

#include "studies/analysis/curve_audit.h"
#include "studies/analysis/study_data.h"
#include "studies/statistics/fragility.h"
#include "studies/statistics/vector_fragility.h"

namespace gurney::study {

/// Two measures of StudyData::measures(), not the same.
using MeasurePair = std::array<std::string, 2>;

/// How likely a limit state is, given two intensities. Intensities are SI.
struct VectorResult {
  std::string configuration, state, words;
  std::array<RunMeasure, 2> measures;
  std::vector<statistics::VectorObservation> runs;  ///< those that have both measures
  std::size_t left_out = 0, failed = 0;
  statistics::VectorFit fit;
  std::array<statistics::FragilityFit, 2> alone;  ///< of the same runs with one measure
  CurveAudit audit;  ///< of outcomes and records; two measures have no range to leave
};

/// @throws Error for a measure that the file lacks, or the same one twice
VectorResult vector_of(const StudyData& data, std::size_t state, std::size_t configuration,
                       const MeasurePair& measures);

}  // namespace gurney::study
