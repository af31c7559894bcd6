#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/statistics/capacity.h"
#include "studies/statistics/fragility.h"
#include "studies/study/analysis/curve_audit.h"
#include "studies/study/analysis/study_data.h"

namespace gurney::study {

/// The fragility curve of a limit state and a configuration, without intervals.
struct FittedCurve {
  std::vector<statistics::Observation> observations;
  statistics::FragilityFit fit;                       ///< of the outcomes of runs
  std::vector<statistics::Capacity> brackets;         ///< of an IDA: one for each record; else none
  std::optional<statistics::CapacityFit> capacities;  ///< of the brackets
  CurveAudit audit;

  /// The curve to be used: of capacities after an IDA, else of the fit. None: see status().
  std::optional<statistics::LognormalCurve> curve() const {
    return capacities ? capacities->curve : fit.curve;
  }
  statistics::FragilityStatus status() const {
    return capacities ? capacities->status : fit.status;
  }
  const statistics::MedianBounds& median() const {
    return capacities ? capacities->median : fit.median;
  }
};

/// An IDA gives capacities for the limit state that ends it, over its own measure; for all others
/// its runs are outcomes like those of stripes.
FittedCurve fitted_curve(const StudyData& data, std::size_t state, std::size_t configuration,
                         const RunMeasure& measure);

}  // namespace gurney::study
