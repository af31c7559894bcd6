#pragma once

#include "engine/base/vector.h"

namespace gurney {

/// Rolling resistance of a round body (docs/theory/parts.md). The pressure below it runs ahead of it by the
/// path e that it has rolled, as long as its moment is within the rolling friction length b times N:
///
///     M = -W (e + T e'),   |M| <= b N,   e' = R w - slip
///
/// with w the angular velocity between the bodies about the directions in which it rolls, and W the weight of
/// the body. It comes to rest as on a flat of half width b, with the energy W e^2 / (2 R). e is a floor vector,
/// along w.
struct RollingResistance {
  double length = 0;  ///< b > 0 [m]
  double radius = 0;  ///< R > 0 [m]
  double weight = 0;  ///< W > 0 [N]
  /// P: onto the axis of a cylinder; of a sphere, onto the plane of contact.
  Matrix3 directions = Matrix3::Zero();

  /// T damps the rocking on that flat, whose period is around 0.5 s: to a third with each swing. Numerical:
  /// it moves the place where the body stands by less than b [s].
  static constexpr double kDampingTime = 0.05;

  struct Result {
    Vector3 moment = Vector3::Zero();  ///< along +w [N m]
    Matrix3 slope = Matrix3::Zero();   ///< -dM/dw at a constant N [N m s]
    Vector3 lead = Vector3::Zero();    ///< e at the end of the stage [m]
    double loss = 0;                   ///< >= 0 [W]
    double spring_rates = 0;           ///< W / R e'^2 [W/s]
  };

  /// @param lead    e at the start of a stage of length tau
  /// @param rate    angular velocity between the bodies at its end [rad/s]
  /// @param normal  N >= 0 at its end [N]
  Result evaluate(const Vector3& lead, const Vector3& rate, double normal, double tau) const {
    Result result;
    const Vector3 rolling = radius * (directions * rate), before = directions * lead;
    Vector3 arm = before + (tau + kDampingTime) * rolling;
    result.slope = weight * radius * (tau + kDampingTime) * directions;
    const double size = arm.norm(), limit = length * normal / weight;
    if (size > limit) {
      const Vector3 along = arm / size;
      arm = limit * along;
      result.slope *= limit / size;
      result.slope -= along * (along.transpose() * result.slope);
    }
    result.moment = -weight * arm;
    result.lead = (tau * arm + kDampingTime * before) / (tau + kDampingTime);
    const Vector3 lead_rate = (result.lead - before) / tau;
    result.loss = weight / radius * (arm.dot(rolling) - result.lead.dot(lead_rate));
    result.spring_rates = weight / radius * lead_rate.squaredNorm();
    return result;
  }

  double stored_energy(const Vector3& lead) const {
    return 0.5 * weight / radius * lead.squaredNorm();
  }
};

}  // namespace gurney
