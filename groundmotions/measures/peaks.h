#pragma once

#include <Eigen/Core>

namespace gurney::groundmotions {

/// Peak ground acceleration, velocity and displacement of one component: the largest magnitudes at
/// the samples, starting from rest. Velocity and displacement are the exact integrals of the
/// acceleration taken as linear between samples (for the velocity, the trapezoidal rule); no
/// baseline correction, no filter.
struct Peaks {
  double acceleration = 0;          ///< PGA [m/s2]
  double velocity = 0;              ///< PGV [m/s]
  double displacement = 0;          ///< PGD [m]
  double time_of_acceleration = 0;  ///< first sample with PGA [s]
};

/// @param time_step     > 0 [s]
/// @param acceleration  [m/s2]; empty: all peaks are zero
Peaks peaks(double time_step, const Eigen::VectorXd& acceleration);

/// Peaks of the resultants: the largest lengths of the horizontal vectors.
/// @param h1, h2  at right angles, of one length [m/s2]
Peaks peaks(double time_step, const Eigen::VectorXd& h1, const Eigen::VectorXd& h2);

}  // namespace gurney::groundmotions
