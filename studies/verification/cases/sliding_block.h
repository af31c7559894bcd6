#pragma once

#include "studies/verification/check.h"

/// A block that slides without friction along +x into something, at the default step of 4 ms.
namespace gurney::verification {

/// A step that may meet a contact is cut to 1/32 of half the period of a spring with the stiffness
/// of all points that are near, on the effective mass of one point (docs/theory/impact.md).
inline constexpr double kStepsInImpact = 32;
inline constexpr double kFloorPoints = 4;  ///< on which a block stands

/// The steps of an impact: phi = omega h, omega^2 = (points k) / mass.
///
/// A contact begins and ends inside a step, where its force has a kink. Of a step of the method
/// (engine/solver/quadrature.h) of which the part theta is before the touch, the two stages give
/// the impulse (1 - gamma) max(0, gamma - theta) + gamma (1 - theta) where (1 - theta)^2 / 2 is
/// right, in units of phi^2 v. They differ by gamma^2 / 2 at most, and by as much where it ends.
/// In between the method is of second order and symmetric parts return what they take: integrated
/// by it in every place of the touch, the rebound of engine/contact/impact_law.h is within
/// e gamma^2 phi^2 v for e in 0.05 to 1, and that of a damper whose force is capped, with two kinks
/// more, within 2 gamma^2 phi^2 v.
///
/// Such a step loses or gains k s^2 / 2, s = (1 - 2 gamma) v h (flight.cpp), which is
/// (1 - 2 gamma)^2 phi^2 of the energy and a numerical loss of the balance.
struct ImpactSteps {
  double phase;

  /// @param mass  that meets the `points` as one [kg]
  /// @param mass_at_point  effective mass of the body at a point [kg]
  /// @param near  all points of the item, those on the floor too
  ImpactSteps(double mass, double mass_at_point, double points, double near);

  double speed_error() const;  ///< of an elastic rebound, over the speed
};

struct SlidingBlock {
  double mass;   ///< [kg]
  Vector3 size;  ///< its front is at x = size.x() / 2 [m]

  double yaw_inertia() const;
  /// 1 / (n M^-1 n) at a point [m, from the centre] along the unit vector `direction` [kg].
  double effective_mass(const Vector3& point, const Vector3& direction) const;
  /// Its front meets a wall with four corners.
  ImpactSteps front_steps() const;
  Scene scene(const Vector3& velocity) const;
};

inline constexpr double kWayToImpact = 0.1;  ///< of the block before it touches [m]

/// Bound of the energy balance error over the energy at the start: losses and gains of a contact inside a step are
/// numerical loss.
Expected closes_over(double time, double speed);

/// Runs for the time that the block takes for `travel`. Adds the check of the energy balance and of
/// the number of impacts, one.
Response slide(Runner& runner, const Scene& scene, double travel);

/// At the end of the run, of a block upright [rad/s].
double yaw_rate_at_end(const Response& response, std::size_t item = 0);

/// A spring k with a damper c that can at most double the force and never pulls, met by m:
/// m d'' = -(k d + min(max(c d', -k d), k d)), d(0) = 0, d'(0) = 1. While c d' > k d the force is
/// 2 k d; then it is a damped oscillator, until c d' = -k d ends the contact.
struct CappedDamping {
  double restitution, duration;  ///< [-], [s]
  double peak;                   ///< largest force over m [m/s2 for 1 m/s]

  /// @param omega  sqrt(k / m) [rad/s]
  /// @param zeta  c / (2 sqrt(k m)), in [0, 1)
  CappedDamping(double omega, double zeta);
};

}  // namespace gurney::verification
