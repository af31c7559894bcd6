#pragma once

#include <string>

#include "studies/verification/runner.h"

/// A block that slides without friction along +x into something, at the default step of 4 ms.
namespace gurney::verification {

/// A step that may meet a contact is cut to 1/32 of half the period of the contact's spring
/// (docs/theory/impact.md): a phase of pi / 32. A method of second order misses its square over 12
/// of the speed, and as much for the touch and the end inside steps; four times its fourth power of
/// the energy.
inline constexpr double kStepsInImpact = 32;
inline constexpr double kPhase = 3.14159265358979 / kStepsInImpact;
inline constexpr double kImpactError = 2 * kPhase * kPhase / 12;
inline constexpr double kImpactClosure = 5 * kPhase * kPhase * kPhase * kPhase;

struct SlidingBlock {
  double mass;   ///< [kg]
  Vector3 size;  ///< its front is at x = size.x() / 2 [m]

  double yaw_inertia() const;
  Scene scene(const Vector3& velocity) const;
};

inline constexpr double kWayToImpact = 0.1;  ///< of the block before it touches [m]

/// Runs for the time that the block takes for `travel`. Adds the check of the energy account and of
/// the number of impacts, one.
Response slide(Findings& findings, const Runner& runner, const Scene& scene, double travel,
               double closure = kImpactClosure);

/// Of the last history step [rad/s].
double yaw_rate_at_end(const Response& response, std::size_t item = 0);

/// Longest contact of restitution e over that of the elastic one, pi sqrt(m / k): integrated, the
/// law of engine/contact/impact_law.h stays below (1 + e) / (2 sqrt(e)) for e in 0.01 to 1.
double longest_contact(double restitution);

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
