#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "studies/statistics/bands.h"

namespace gurney::statistics {

/// y_i = x_i . b + u_i + e_i: u_i scatters between units with an unknown standard deviation, e_i
/// has the known one of its measurement.
struct RandomEffects {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;
  double scatter = 0;  ///< standard deviation of u
  int degrees = 0;     ///< n - p

  double error(Eigen::Index i) const;                                 ///< standard error of b_i
  Interval interval(Eigen::Index i, double confidence = 0.95) const;  ///< by Student's t
  double p_value(Eigen::Index i, double supposed = 0) const;          ///< two-sided
};

/// Least squares with the weights 1 / (scatter^2 + error_i^2). The scatter is that of Paule &
/// Mandel (1982, J. Res. Natl. Bur. Stand. 87(5), 377-385): the weighted sum of squares equals n -
/// p, or 0 where it is less without any. Student's t and the covariance of Knapp & Hartung (2003,
/// Statistics in Medicine 22(17), 2693-2710), with the factor (sum of squares) / (n - p), never
/// below 1. Exact where the errors are equal and less than the scatter, or small; where errors make
/// all of the scatter it is wide.
///
/// @param design  a row for each unit
/// @return nothing unless n > p and the columns are independent
/// @throws Error unless every error is >= 0 and finite.
std::optional<RandomEffects> fit_random_effects(const Eigen::VectorXd& y,
                                                const Eigen::VectorXd& error,
                                                const Eigen::MatrixXd& design);

/// Two-sided p of each group against what all others predict (fit without it, prediction with the
/// scatter; Student's t with n - p - 1 degrees), times n (Bonferroni), at most 1. 1 where the
/// others cannot be fitted.
std::vector<double> outlier_p_values(const Eigen::VectorXd& y, const Eigen::VectorXd& error,
                                     const Eigen::MatrixXd& design);

}  // namespace gurney::statistics
