#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

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
  kTogether,      ///< one measure is a power of the other: their effects cannot be distinguished
  kSeparated,     ///< a line in the plane of both parts the outcomes, or nearly: no maximum
  kNotIncreasing  ///< the slopes do not sum to more than 0: no lognormal curve of a combination
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
  std::size_t runs = 0, exceeded = 0, groups = 0;

  double probability(double first, double second) const;
  double share() const;  ///< of the first in the combination
  double theta() const;  ///< of the combination
  double beta() const;

  /// P of a slope at least so far from 0 by chance, from Student's t with groups - 1 degrees and
  /// the cluster covariance; with one group from the normal and the covariance of independent runs.
  /// Somewhat too small with few groups: of slopes of 0 7 % have p < 0.05 with 40 groups of five.
  /// @param slope  0: of the first; 1: of the second
  double p_of(Eigen::Index slope) const;
};

/// By Newton's method on logarithms less their mean over their deviation. Separation is reported
/// where the plane found leaves no run on its wrong side, or where the information is singular to
/// 1e-9.
/// @throws Error unless all intensities are > 0 and finite.
VectorFit fit_vector(const std::vector<VectorObservation>& observations);

}  // namespace gurney::statistics
