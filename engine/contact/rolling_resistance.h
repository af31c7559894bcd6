#pragma once

#include "engine/base/vector.h"

namespace gurney {

/// Rolling resistance of a round body (docs/theory/parts.md). The pressure below it runs ahead of it by the
/// path that it has rolled, up to the rolling friction length b:
///
///     M = -N (e + T e'),   |M| <= b N,   e' = R w - slip
///
/// with w the angular velocity between the bodies about the directions in which it rolls. It comes to rest as on
/// a flat of half width b. e is a floor vector, along w.
struct RollingResistance {
  double length = 0;  ///< b > 0 [m]
  double radius = 0;  ///< R > 0 [m]
  /// P: onto the axis of a cylinder; of a sphere, onto the plane of contact.
  Matrix3 directions = Matrix3::Zero();

  /// T damps the rocking on that flat, of a period around 0.5 s: by a third of what stops it within one swing.
  /// Numerical: the path until the body stands is b either way [s].
  static constexpr double kDampingTime = 0.05;

  struct Result {
    Vector3 moment = Vector3::Zero();  ///< along +w [N m]
    Matrix3 slope = Matrix3::Zero();   ///< -dM/dw [N m s]
    Vector3 lead = Vector3::Zero();    ///< e at the end of the stage [m]
  };

  /// @param lead    e at the start of a stage of length tau
  /// @param rate    angular velocity between the bodies at its end [rad/s]
  /// @param normal  N >= 0 at its end [N]
  Result evaluate(const Vector3& lead, const Vector3& rate, double normal, double tau) const {
    Result result;
    const Vector3 rolling = radius * (directions * rate), before = directions * lead;
    Vector3 arm = before + (tau + kDampingTime) * rolling;
    result.slope = normal * radius * (tau + kDampingTime) * directions;
    if (const double size = arm.norm(); size > length) {
      const Vector3 along = arm / size;
      arm = length * along;
      result.slope *= length / size;
      result.slope -= along * (along.transpose() * result.slope);
    }
    result.moment = -normal * arm;
    result.lead = (tau * arm + kDampingTime * before) / (tau + kDampingTime);
    return result;
  }
};

}  // namespace gurney
