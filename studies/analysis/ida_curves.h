#pragma once

#include <limits>
#include <vector>

#include "studies/analysis/demand_runs.h"

namespace gurney::study {

/// The demands of one analysis case as its record is scaled (Vamvatsikos & Cornell 2002, EESD
/// 31(3), 491-514), up to the first overturning.
struct IdaCurve {
  std::vector<double> im, demand;  ///< im increases; the first point is (0, 0)
  /// Where the item overturns: the geometric mean of the intensities around it (that above where
  /// there is none below); infinity: it does not.
  double capacity = std::numeric_limits<double>::infinity();

  /// Linear between the runs; infinity from `capacity` on; NaN: above the last run.
  double demand_at(double intensity) const;
};

std::vector<IdaCurve> ida_curves(const std::vector<DemandRun>& runs);

/// The demand that a fraction of the curves does not exceed at an intensity, of those known there:
/// linear between the ordered values, the i-th of n standing at (i - 1/2) / n (Hazen 1914).
/// Infinity where that many have overturned; NaN where fewer than half of the curves are known.
double fractile_at(const std::vector<IdaCurve>& curves, double intensity, double fraction);

}  // namespace gurney::study
