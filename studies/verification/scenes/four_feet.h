#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

namespace gurney {

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
