#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/base/vector.h"

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

/// A residual velocity that is visible however long the record [m/s].
inline constexpr double kVisibleVelocity = 0.05;

/// Residual motion at the end of a floor motion, and whether that is plausible.
///
/// An item on casters integrates the floor's acceleration twice by itself. In a prototype of this
/// engine a baseline error of 0.001 g moved a trolley's peak displacement from 0.38 to 0.56 m. If
/// the effect is linear (an assumption), 0.0001 g is worth some 5 % of the peak. Two rules, on the
/// horizontal resultants, with T the duration of the record:
///
/// 1. |v_residual| > clamp(0.0001 g T, 0.01 m/s, 0.05 m/s): the mean acceleration of the
///    record, v_residual / T, is a baseline error that matters. Below 0.01 m/s what is left moves
///    nothing visibly; 0.05 m/s is visible however long the record.
/// 2. |d_residual| > 0.05 m and > half the largest floor displacement: the floor does not come
///    back. This is real for permanent ground displacement near a fault, and otherwise a
///    baseline error.
struct Residual {
  Vector3 velocity = Vector3::Zero();      ///< at the last sample, from rest at the first [m/s]
  Vector3 displacement = Vector3::Zero();  ///< likewise [m]
  std::vector<std::string> warnings;       ///< one for each rule that is broken
};

Residual residual(const FloorMotion& floor);

}  // namespace gurney::groundmotions
