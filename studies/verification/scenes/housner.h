#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <functional>

/// The rigid block that rocks on two edges (Housner 1963), integrated: a reference of verification.

namespace gurney {

struct RockingBlock {
  double alpha = 0;  ///< atan(half width / height of the centre) [rad]
  double p = 0;      ///< sqrt(M g R / I_O) [1/s]
  double eta = 0;    ///< angular velocity after an impact over that before
};

/// With s the sign of theta, on the edge it stands on,
///
///     theta'' = -p^2 (sin(alpha s - theta) + a(t) / g cos(alpha s - theta))
///
/// from uplift, |a| > g tan(alpha), on; theta' is multiplied by eta at theta = 0. Runge-Kutta steps
/// of fourth order; impacts are located.
class RockingReference {
 public:
  explicit RockingReference(const RockingBlock& block) : block_(block) {}

  /// Goes on for `duration` under the floor acceleration a(time since the start) [m/s2], or until
  /// the block falls.
  void advance(const std::function<double(double)>& acceleration, double duration);

  /// The floor's velocity changes at once by `change`: theta' by -p^2 / g cos(alpha s - theta) of
  /// it.
  void jump(double change);

  bool fallen() const;  ///< beyond 1 rad
  int impacts() const { return impacts_; }
  double time() const { return time_; }
  double theta() const { return theta_; }

 private:
  void step(const std::function<double(double)>& acceleration, double h);

  RockingBlock block_;
  double time_ = 0, theta_ = 0, rate_ = 0;
  double sign_ = 0;  ///< of theta; 0: stands on both edges
  int impacts_ = 0;
};

/// Time from rest at theta0 to the floor, from the energy integral [s].
double quarter_period(const RockingBlock& block, double theta0);

/// How a block ends under one cycle of a sine, a(t) = a_p sin(w_p t) (Zhang & Makris 2001).
enum class RockingEnd { kStands, kAfterImpact, kWithoutImpact };

/// With growing strength a_p / (alpha g) the block overturns after one impact from a on, is safe
/// again from b on, and overturns without impact from c on; it falls the other way then. Where w_p
/// / p is large, only c is left and a = b = 0.
struct SineRegions {
  double a = 0, b = 0, c = 0;

  /// @param ratio  w_p / p
  SineRegions(const RockingBlock& block, double ratio);

  static RockingEnd end(const RockingBlock& block, double ratio, double strength);

  /// The strength between `without` and `with` from which on the block ends as `end`.
  static double boundary(const RockingBlock& block, double ratio, RockingEnd end, double without,
                         double with);
};

/// A rigid body on four feet, each the rim of a wheel that a stiff spring holds on its axle,
/// integrated by the classical Runge-Kutta method. It shares no code with the engine; the laws of
/// the tread are taken as given (docs/theory/tread.md):
///
///     N = k_n d + min(max(c_n d', -k_n d), k_n d)
///     F = -T if |T| <= mu N, T = k_t e + c_t u, e' = u
///     F = -mu N T / |T| otherwise,  c_t e' = -F - k_t e;  off the floor e = 0
struct FourFeet {
  using Vector3 = Eigen::Vector3d;

  double mass = 0;                                  ///< all of it [kg]
  Vector3 inertia = Vector3::Zero();                ///< principal, about its centre, along x, y, z
  std::array<Vector3, 4> wheels;                    ///< centres, from the body's centre [m]
  double radius = 0, wheel_inertia = 0;             ///< about the axle [m], [kg m2]
  double axle_stiffness = 0;                        ///< [N m/rad]
  double normal_stiffness = 0, normal_damping = 0;  ///< [N/m], [N s/m]
  double tangential_stiffness = 0, tangential_damping = 0;  ///< [N/m], [N s/m]
  double friction = 0, gravity = 0;

  /// Position (3), quaternion (w x y z), velocity (3), angular velocity (3), and of each foot the
  /// axle's angle and rate and the deflection (2).
  using Motion = Eigen::Matrix<double, 29, 1>;

  /// At rest with its centre above the middle of the feet.
  Motion at_rest() const;
  /// One step of h under floor accelerations at its start, middle and end.
  void step(Motion& y, double h, const std::array<Vector3, 3>& floor) const;

  Vector3 point(const Motion& y, const Vector3& from_centre) const;
  double tilt(const Motion& y) const;
  int feet_on_floor(const Motion& y) const;

 private:
  struct Foot {
    Vector3 axle, arm, rim;  // arm: from the body's centre to the contact; rim: from the wheel's
    double depth = 0;
  };
  Foot foot(const Motion& y, const Eigen::Matrix3d& rotation, std::size_t i) const;
  Motion rates(const Motion& y, const Vector3& floor) const;
};

}  // namespace gurney
