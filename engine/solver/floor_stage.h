#pragma once

#include <array>

#include "engine/base/floor_motion.h"

namespace gurney {

/// Inertia forces of the floor in one implicit stage, in the frame of the floor. For a its translation,
/// theta its small rotation and r the place from the origin, a mass m feels
///
///     m (g - a - theta x g - theta'' x r),
///
/// theta x g being what the tilted floor makes of gravity. Left out are g theta^2 / 2, the
/// centrifugal acceleration theta'^2 r and the Coriolis acceleration 2 theta' x v: 1e-4, 1e-3 and
/// 0.06 m/s2 for 5 mrad at 1 Hz, 1 m and 1 m/s.
struct FloorStage {
  Vector3 acceleration = Vector3::Zero();  ///< a + theta x g, the same for every mass [m/s2]
  Vector3 translation = Vector3::Zero();   ///< a [m/s2]
  Vector3 angular_acceleration = Vector3::Zero();  ///< theta'' [rad/s2]
  bool rotates = false;

  /// Acceleration of a point of the floor, in the inertial frame [m/s2].
  Vector3 acceleration_at(const Vector3& place) const {
    return rotates ? translation + angular_acceleration.cross(place) : translation;
  }
};

/// Both stages of a step. Their weighted sum is the exact mean of the floor's motion over the step.
/// @param gravity  floor axes [m/s2]
std::array<FloorStage, 2> floor_stages(const FloorMotion& floor, const Vector3& gravity,
                                       double time, double duration);

/// Integral of a + theta x g from 0 to `time` [m/s].
Vector3 apparent_floor_velocity(const FloorMotion& floor, const Vector3& gravity, double time);

}  // namespace gurney
