#pragma once

#include "engine/base/vector.h"
#include "engine/scene/contact_pair.h"

namespace gurney {

/// Force of the floor or a room shape on a body of the item (docs/theory/impact.md).
///
/// Law of an impact. With the compression d, its rate d' = -u_z and the approach speed v0 at the first touch:
///
///     N = k d (1 + g)  for d > 0, else 0,
///     restitution e:         g = max(x(e) d' / v0, -1),   (1 + e) x = ln((1 + x) / (1 - e x))
///     compliant k, c:        g = c d' / (k d), at most 1 and at least -1
///     e_t' = u_t - slip,  F_t = -(k_t e_t + c_t e_t'),  |F_t| <= mu N
///
/// The first is the force of Hunt & Crossley (1975) with the exact relation between its damping and
/// e: dividing m d'' = -k d (1 + x d'/v0) by its bracket and integrating from v0 to -e v0 leaves
/// neither mass nor stiffness. It never pulls before separation, since e x < 1. Approaches slower
/// than kLeastApproach rebound with less than e.
///
/// The tangential deflection e_t is a floor vector; it ends with the contact. k_t = 0.8 k is
/// Mindlin's ratio 2 (1 - nu) / (2 - nu) for nu = 0.3 (1949); c_t = k_t times 1 ms damps stuck
/// bodies.
class ImpactLaw {
 public:
  explicit ImpactLaw(const ContactConstants& constants);

  static constexpr double kLeastApproach = 0.01;  ///< [m/s]

  /// Damping number x of a restitution e in 0.01..1.
  static double damping_number(double restitution);

  struct Stage {
    double tau = 0;
    double compression = 0;  ///< at zero u_z: d = compression - tau u_z [m]
    double approach_speed = 0;
    Vector2 deflection = Vector2::Zero();
    double turned = 0;  ///< of the compression: what it is more than at the start of the stage [m]
    double ahead = 0;   ///< as OneSidedStage
  };
  struct Result {
    Vector3 force = Vector3::Zero();
    Vector2 deflection = Vector2::Zero();  ///< at the end of the stage [m]
    double compression = 0;
    bool sliding = false;      ///< friction at its limit
    double sliding_power = 0;  ///< [W]
    double damping_power = 0;  ///< [W]
    double spring_rates = 0;   ///< sum of k x'^2 [W/s]
  };

  /// @param u  velocity of the body's point: two tangents and the normal (away from the other)
  /// @param slope  becomes -df/du
  Vector3 force(const Stage& stage, const Vector3& u, Matrix3& slope) const;
  /// New state and powers at the velocity that solves the stage, where `force` is the force.
  Result finish(const Stage& stage, const Vector3& u, const Vector3& force) const;

  double stored_energy(double compression, double deflection) const;
  /// Slope of the force at the first touch: how fast an impact changes [N/m].
  double impact_stiffness() const { return stiffness_ * (1 + damping_number_); }
  double stiffness() const { return stiffness_; }  ///< k [N/m]
  double tangential_stiffness() const { return tangential_stiffness_; }
  double friction() const { return friction_; }
  double rolling_resistance() const { return rolling_resistance_; }  ///< [m]
  bool compliant() const { return compliant_; }

 private:
  struct Normal {
    double force, slope, damping_force;
  };
  Normal normal(const Stage& stage, double u_z) const;
  /// c_t over tau, and how c_t grows with the compression.
  struct Tangent {
    double damping_rate, damping_by_depth;
  };
  Tangent tangent(const Stage& stage, const Vector3& u) const;
  double damping_slope(const Stage& stage) const;  // x / v0

  bool compliant_;
  double stiffness_, damping_, damping_number_, friction_;
  double tangential_stiffness_, rolling_resistance_;
};

}  // namespace gurney
