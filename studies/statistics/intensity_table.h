#pragma once

#include <string>
#include <vector>

#include "studies/statistics/cloud.h"

namespace gurney::statistics {

/// A number for each run: an intensity measure or a property of its record; NaN where unknown.
struct NamedValues {
  std::string name;
  std::vector<double> values;
};

/// One intensity measure as a predictor of one demand.
struct IntensityRow {
  std::string name;
  CloudStatus status = CloudStatus::kTooFewExact;
  int runs = 0, left_out = 0;  ///< left out: im unknown or not > 0
  double efficiency = 0;       ///< sigma of ln EDP given IM; smaller is better (Shome et al. 1998)
  double practicality = 0;     ///< the slope b: how much the demand depends on it at all
  double proficiency = 0;  ///< sigma / |b| (Padgett, Nielsen & DesRoches 2008, EESD 37(5), 711-725)
  double r_squared = 0;
  double log_likelihood = 0;  ///< comparable between rows that left out none

  /// For each property: p of no dependence of the demand on it once IM is known, the sufficiency of
  /// Luco & Cornell (2007, Earthquake Spectra 23(2), 357-392). NaN where it is unknown, constant,
  /// or known for fewer than 5 runs.
  std::vector<double> sufficiency;
};

/// A row for each measure, in order. Demands may be censored: all is by fit_cloud(), and
/// sufficiency by the censored regression on ln IM and the property together. With each run from a
/// record of its own p is of F = (exp(LR / n) - 1)(n - 3), which is the t-test where no demand is
/// censored; else of Wald's t with the covariance for groups and groups - 1 degrees.
/// @param demands  their im is not read
/// @throws Error unless every column has a value for each demand; as fit_cloud() for edp.
std::vector<IntensityRow> compare_intensities(const std::vector<CloudPoint>& demands,
                                              const std::vector<NamedValues>& measures,
                                              const std::vector<NamedValues>& properties);

}  // namespace gurney::statistics
