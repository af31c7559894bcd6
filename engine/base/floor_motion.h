#pragma once

#include <string>
#include <vector>

#include "engine/base/vector.h"

namespace gurney {

/// Rotation of a floor: right-handed about its three axes, in rows; it rocks about the horizontal ones
/// and yaws about the vertical. Both histories are piecewise linear; the second one is given, not
/// the derivative of the first, which would be a row of impulses.
struct FloorRotation {
  Eigen::Matrix3Xd angle;         ///< small: sin(angle) = angle, cos(angle) = 1 [rad]
  Eigen::Matrix3Xd acceleration;  ///< second derivative of the angle [rad/s2]
};

/// The floor's acceleration and rotation in floor axes, piecewise linear between samples and zero
/// before the first and after the last. Record times are simulation times: the first sample is at 0
/// s. The translation is that of the origin of the floor axes, through which the axes of the
/// rotation pass.
class FloorMotion {
 public:
  FloorMotion() = default;  ///< a floor at rest

  /// @param acceleration  one column for each sample [m/s2]
  /// @throws Error unless time_step > 0 and every value is finite.
  FloorMotion(double time_step, Eigen::Matrix3Xd acceleration, std::string name = {});

  /// Copy with a rotation of as many samples.
  /// @throws Error for another number of samples and for values that are not finite.
  FloorMotion with_rotation(const FloorRotation& rotation) const;

  /// Copy with the rocking times a factor; the yaw stays.
  FloorMotion with_rocking_times(double factor) const;

  double time_step() const { return time_step_; }
  double duration() const;  ///< time of the last sample [s]; 0 for a floor at rest
  const Eigen::Matrix3Xd& acceleration() const { return acceleration_; }
  const std::string& name() const { return name_; }
  bool at_rest() const { return acceleration_.cols() == 0; }
  bool rotates() const { return angle_.cols() > 0; }
  FloorRotation rotation() const;  ///< empty unless it rotates

  Vector3 acceleration_at(double time) const;

  /// Exact integral of the piecewise-linear acceleration from 0 to `time` [m/s].
  Vector3 velocity_at(double time) const;

  /// Integrals of the angle [rad s] and of the angular acceleration [rad/s].
  Vector3 integral_of_angle_at(double time) const;
  Vector3 angular_velocity_at(double time) const;

  /// Velocity and displacement left at the end of the record, starting from rest [m/s], [m].
  Vector3 residual_velocity() const;
  Vector3 residual_displacement() const;

 private:
  Vector3 integral_at(const Eigen::Matrix3Xd& values, const Eigen::Matrix3Xd& integral,
                      double time) const;

  double time_step_ = 0;
  Eigen::Matrix3Xd acceleration_;
  Eigen::Matrix3Xd velocity_;                      ///< exact integral at the samples
  Eigen::Matrix3Xd displacement_;                  ///< exact double integral at the samples
  Eigen::Matrix3Xd angle_, angular_acceleration_;  ///< empty unless the floor rotates
  Eigen::Matrix3Xd angle_integral_, angular_velocity_;
  std::string name_;
};

}  // namespace gurney
