#pragma once

#include <Eigen/Core>

namespace gurney::groundmotions {

/// Velocity and displacement at the samples, from rest at the first one.
struct IntegratedMotion {
  Eigen::VectorXd velocity;      ///< [m/s]
  Eigen::VectorXd displacement;  ///< [m]
};

/// The exact integrals of an acceleration that is linear between its samples:
///
///     v_i = v_(i-1) + h (a_(i-1) + a_i) / 2
///     d_i = d_(i-1) + h v_(i-1) + h^2 (2 a_(i-1) + a_i) / 6
///
/// @param time_step     h > 0 [s]
/// @param acceleration  [m/s2]; may be empty
IntegratedMotion integrated(double time_step, const Eigen::VectorXd& acceleration);

/// The last values of integrated().
struct EndMotion {
  double velocity = 0;      ///< [m/s]
  double displacement = 0;  ///< [m]
};
EndMotion end_motion(double time_step, const Eigen::VectorXd& acceleration);

}  // namespace gurney::groundmotions
