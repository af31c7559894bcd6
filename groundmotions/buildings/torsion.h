#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "engine/base/vector.h"
#include "groundmotions/measures/response_spectrum.h"

namespace gurney::groundmotions {

/// A building whose floors twist: rigid in their planes, with their centres of mass off the vertical
/// axis through the centres of stiffness of all storeys. With u_x, u_y the displacements of the floors
/// at that axis, theta their yaw, e the place of a centre of mass and r the radius of gyration about it,
///
///     strain energy   (u_x' K_x u_x + u_y' K_y u_y + theta' K_t theta) / 2
///     kinetic energy  sum m ((u_x' - e_y theta')^2 + (u_y' + e_x theta')^2 + (r theta')^2) / 2
///
/// K_t = Omega^2 r^2 K_x: without eccentricity the building twists at Omega times its frequencies along h1
/// (Chopra, Dynamics of Structures, section 13.3).
struct TorsionalBuilding {
  Eigen::VectorXd mass = {};                      ///< of floors 1 to n > 0 [kg]
  std::array<Eigen::MatrixXd, 2> stiffness = {};  ///< K_x, K_y, symmetric positive definite [N/m]
  Eigen::Matrix2Xd eccentricity = {};             ///< e of each floor [m]
  double gyration = 1;                            ///< r > 0 [m]
  double frequency_ratio = 1;                     ///< Omega > 0
};

/// Matrices of u_x, u_y and r theta of all floors, in this order, all in metres.
struct TwistingMatrices {
  Eigen::MatrixXd mass, stiffness;
  Eigen::MatrixXd carried;  ///< 3 n x 2: displacements where the ground moves by 1 along h1 or h2
};

/// @param torsional  K_t / r^2 [N/m]
TwistingMatrices twisting_matrices(const Eigen::VectorXd& mass,
                                   const Eigen::Matrix2Xd& eccentricity, double gyration,
                                   const std::array<Eigen::MatrixXd, 2>& stiffness,
                                   const Eigen::MatrixXd& torsional);

/// Farthest place of a floor from its axis of stiffness, along h1 or h2 [m]: the longest hospitals have 500 m.
inline constexpr double kFarthestPlace = 500;

/// One of its modes, driven by the ground along both axes: q'' + 2 zeta omega q' + omega^2 q = -Gamma . a.
struct TorsionMode {
  double omega = 0;       ///< > 0 [rad/s]
  double damping = 0;     ///< zeta in [0, 1)
  Vector2 participation;  ///< Gamma along h1 and h2
  /// u_x, u_y at the axis of stiffness and theta [rad/m] of floors 0 (the base: 0) to n, one column each.
  Eigen::Matrix3Xd shape;
};

/// All 3 n modes, undamped, in rising order.
std::vector<TorsionMode> torsion_modes(const TorsionalBuilding& building);

/// Motion of a place of a floor whose axis of stiffness moves by `axis`: u_x, u_y and theta.
inline Vector2 at_place(const Vector2& place, const Vector3& axis) {
  return {axis.x() - axis.z() * place.y(), axis.y() + axis.z() * place.x()};
}

/// The motion of one place of a floor: a_ground + sum phi_i(place) q_i'', and the floor's yaw, with the
/// exact step for a ground acceleration that is linear between samples.
class TorsionResponse {
 public:
  /// @param place  on the floor, from the axis of stiffness [m]
  TorsionResponse(const std::vector<TorsionMode>& modes, Eigen::Index floor, const Vector2& place,
                  double time_step);

  /// Moves on by one step under the horizontal accelerations of the ground at its ends [m/s2].
  void step(const Vector2& ground0, const Vector2& ground1);

  /// Absolute acceleration of the place along h1 and h2 [m/s2], and yaw acceleration of the floor
  /// [rad/s2], under this ground acceleration.
  Vector3 acceleration(const Vector2& ground) const;
  double yaw() const;  ///< [rad]

  /// Largest difference of the displacements of the place on two floors that follow each other, along h1
  /// or h2, now [m].
  double storey_drift() const;

 private:
  std::vector<TorsionMode> modes_;
  Eigen::Index floor_;
  Vector2 place_;
  std::vector<Oscillator> oscillators_;
};

}  // namespace gurney::groundmotions
