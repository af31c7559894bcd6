#pragma once

#include <Eigen/Core>
#include <vector>

#include "studies/statistics/special.h"

namespace gurney::statistics {

/// Knowledge of a number y: low <= y <= high. Exact where low == high; low = -infinity or high
/// = infinity where one side is open.
struct CensoredValue {
  double low = 0, high = 0;
  double weight = 1;  ///< of its term in the ln likelihood, > 0

  bool exact() const { return low == high; }
};

/// y = x' coefficients + sigma z, z standard normal.
struct CensoredNormalFit {
  /// The likelihood has a maximum with a positive 1 / sigma. False for data that no finite sigma >
  /// 0 describes best: without spread, or with more low values where high ones belong.
  bool found = false;
  Eigen::VectorXd coefficients;
  double sigma = 0;            ///< maximum likelihood, so without a correction for lost degrees
  Eigen::MatrixXd covariance;  ///< of (coefficients, ln sigma), rows independent
  Eigen::MatrixXd cluster_covariance;  ///< the same, groups independent; equal to it with one group
  double log_likelihood = 0;           ///< density where exact, probability where not
};

/// Regression with interval-, left- and right-censored values by maximum likelihood (Tobin 1958,
/// Econometrica 26(1), 24-36). In coefficients / sigma and 1 / sigma the likelihood is concave
/// (Olsen 1978, Econometrica 46(5), 1211-1215; Burridge 1981, J. R. Statist. Soc. B 43(1), 41-45),
/// so Newton's method finds the only maximum if there is one.
///
/// @param design  a row for each value
/// @param groups  number of the row's group; empty: each row is one
/// @throws Error unless the sizes agree, every low <= high and not both are infinite.
CensoredNormalFit fit_censored_normal(const Eigen::MatrixXd& design,
                                      const std::vector<CensoredValue>& values,
                                      const std::vector<std::size_t>& groups = {});

/// The ln likelihood of these rows at the point (coefficients / sigma, 1 / sigma), with its
/// derivatives; -infinity where 1 / sigma <= 0, though rows all open on one side know no sign of
/// it.
Quadratic<Eigen::Dynamic> censored_normal_likelihood(const Eigen::MatrixXd& design,
                                                     const std::vector<CensoredValue>& values,
                                                     const Eigen::VectorXd& point);

}  // namespace gurney::statistics
