#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/statistics/capacity.h"
#include "studies/statistics/fragility.h"
#include "studies/study/analysis/curve_audit.h"
#include "studies/study/analysis/study_data.h"

namespace gurney {

/// The fragility curve of a limit state and a configuration, without intervals.
struct FittedCurve {
  std::vector<Observation> observations;
  FragilityFit fit;                       ///< of the outcomes of runs
  std::vector<Capacity> brackets;         ///< of an IDA: one for each record; else none
  std::optional<CapacityFit> capacities;  ///< of the brackets
  CurveAudit audit;

  /// The curve to be used: of capacities after an IDA, else of the fit. None: see status().
  std::optional<LognormalCurve> curve() const { return capacities ? capacities->curve : fit.curve; }
  FragilityStatus status() const { return capacities ? capacities->status : fit.status; }
  const MedianBounds& median() const { return capacities ? capacities->median : fit.median; }
};

/// An IDA gives capacities for the limit state that ends it, over its own measure; for all others
/// its runs are outcomes like those of stripes.
FittedCurve fitted_curve(const StudyData& data, std::size_t state, std::size_t configuration,
                         const RunMeasure& measure);

}  // namespace gurney
