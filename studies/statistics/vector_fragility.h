#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "studies/statistics/censored_normal.h"

namespace gurney::statistics {

/// One run seen at one limit, with two measures of its intensity.
struct VectorObservation {
  double first = 0, second = 0;  ///< > 0, any units
  bool exceeded = false;
  std::size_t group = 0;  ///< its record
};

enum class VectorStatus {
  kFitted,
  kNoRuns,
  kAllExceed,
  kNoneExceeds,
  kTogether,       ///< one measure is a power of the other: their effects cannot be distinguished
  kSeparated,      ///< a line in the plane of both parts the outcomes, or nearly: no maximum
  kInAllBrackets,  ///< a line in the plane of both runs through all brackets: the same
  kNotIncreasing   ///< the slopes do not sum to more than 0: no lognormal curve of a combination
};

std::string text(VectorStatus status);

/// P(exceeded | a, b) = Phi(plane . (ln a, ln b, 1)): a fragility of a vector-valued intensity
/// (Baker & Cornell 2005, EESD 34(10), 1193-1217; the regression as fit_probit()).
///
/// It is that of the scalar a^share b^(1 - share) with a lognormal curve.
struct VectorFit {
  VectorStatus status = VectorStatus::kNoRuns;
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();          ///< runs independent
  Eigen::Matrix3d cluster_covariance = Eigen::Matrix3d::Zero();  ///< groups are; one group: zero
  double log_likelihood = 0;
  std::size_t runs = 0, exceeded = 0, groups = 0;  ///< runs, or capacities
  Eigen::Vector2d t = Eigen::Vector2d::Zero();     ///< slopes over standard errors, for p_of()
  double degrees = 0;  ///< of freedom of t; 0: of the normal distribution

  double probability(double first, double second) const;
  double share() const;  ///< of the first in the combination
  double theta() const;  ///< of the combination
  double beta() const;

  /// P of a slope at least so far from 0 by chance, from Student's t. Of runs with groups - 1
  /// degrees and the cluster covariance; with one group from the normal and the covariance of
  /// independent runs. Somewhat too small with few groups: of slopes of 0 7 % have p < 0.05 with 40
  /// groups of five.
  /// @param slope  0: of the first; 1: of the second
  double p_of(Eigen::Index slope) const;
};

/// By Newton's method on logarithms less their mean over their deviation. Separation is reported
/// where the plane found leaves no run on its wrong side, or where the information is singular to
/// 1e-9.
/// @throws Error unless all intensities are > 0 and finite.
VectorFit fit_vector(const std::vector<VectorObservation>& observations);

/// Bracket of an analysis case of an incremental dynamic analysis: it exceeds where the first
/// measure is above a capacity within the bracket.
struct VectorCapacity {
  CensoredValue ln_first;  ///< weight: one over the analysis cases of its record
  double ln_ratio = 0;     ///< ln second - power ln first, the same at all its runs
  std::size_t group = 0;   ///< its record
};

/// Plane from brackets: ln capacity in the first measure is m0 + m1 ln_ratio + sigma z, so
/// that plane = (1 + power m1, -m1, -m0) / sigma (Baker & Cornell 2005: capacities regressed on the
/// second measure). Each record counts once, as in fit_capacities(). Both covariances are those of
/// n - 2 degrees of freedom, with which p is Student's where brackets have no width; n counts
/// records by their information on sigma.
/// @param power  1: the second measure grows in proportion to the first along a record; 0: it stays
VectorFit fit_vector_capacities(const std::vector<VectorCapacity>& capacities, double power);

}  // namespace gurney::statistics
