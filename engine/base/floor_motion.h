#pragma once

#include <string>
#include <vector>

#include "engine/base/vector.h"

namespace gurney {

/// The floor's translational acceleration in floor axes, piecewise linear between samples and zero
/// before the first and after the last. Record times are simulation times: the first sample is at 0
/// s.
class FloorMotion {
 public:
  FloorMotion() = default;  ///< a floor at rest

  /// @param acceleration  one column for each sample [m/s2]
  /// @throws Error unless time_step > 0 and every value is finite.
  FloorMotion(double time_step, Eigen::Matrix3Xd acceleration, std::string name = {});

  double time_step() const { return time_step_; }
  double duration() const;  ///< time of the last sample [s]; 0 for a floor at rest
  const Eigen::Matrix3Xd& acceleration() const { return acceleration_; }
  const std::string& name() const { return name_; }
  bool at_rest() const { return acceleration_.cols() == 0; }

  Vector3 acceleration_at(double time) const;

  /// Exact integral of the piecewise-linear acceleration from 0 to `time` [m/s].
  Vector3 velocity_at(double time) const;

  /// Velocity and displacement left at the end of the record, starting from rest [m/s], [m].
  Vector3 residual_velocity() const;
  Vector3 residual_displacement() const;

 private:
  double time_step_ = 0;
  Eigen::Matrix3Xd acceleration_;
  Eigen::Matrix3Xd velocity_;      ///< exact integral at the samples
  Eigen::Matrix3Xd displacement_;  ///< exact double integral at the samples
  std::string name_;
};

}  // namespace gurney
