#pragma once

#include <array>

#include "engine/base/linear_algebra.h"
#include "engine/base/vector.h"

namespace gurney::groundmotions {

/// A shear building whose storeys yield. With d the drift of a storey in h1 and h2, its shear is
///
///     V_a = alpha K_a d_a + (1 - alpha) K_a d_y z_a,   a = h1, h2
///     z' = d' / d_y inside the unit disc; on its edge without the part of d' that leads out of it
///
/// which is bilinear with kinematic hardening along one line, and yields at |d| = d_y in any direction.
/// Neither strength nor stiffness degrades, loops are not pinched, and weight does no work on drift.
struct YieldingStoreys {
  Eigen::VectorXd mass;                      ///< of floors 1 to n > 0 [kg]; only ratios matter
  std::array<Eigen::VectorXd, 2> stiffness;  ///< K of each storey from the ground up > 0 [N/m]
  std::array<Eigen::VectorXd, 2> damping;  ///< of the elastic modes, by rising frequency, in [0, 1)
  Eigen::VectorXd yield_drift;             ///< d_y of each storey > 0 [m]
  double hardening = 0;                    ///< alpha in [0, 1)
};

/// Energies relative to the ground, for the given masses [J]; every term comes from its own force.
struct StoreyEnergy {
  double input = 0;       ///< work of -a_ground
  double kinetic = 0;     ///< now
  double strain = 0;      ///< of alpha K d, now
  double hysteresis = 0;  ///< taken by z; (1 - alpha) K d_y^2 |z|^2 / 2 of it can come back
  double damping = 0;     ///< dissipated by the modes

  double closure() const { return input - kinetic - strain - hysteresis - damping; }
};

/// Its two horizontal motions, solved together by the implicit midpoint rule:
///
///     M u'' + C u' + B' V(B u) = -M 1 a_ground,   C = sum_i 2 zeta_i omega_i M phi_i phi_i' M
///
/// with B the drifts of displacements u and phi_i' M phi_i = 1. Second order, stable for any step. Drifts go
/// straight in a step, so slide() gives the work of z exactly and the energies close to the tolerance of
/// the solve.
class YieldingMotion {
 public:
  /// @param time_step  > 0 [s]
  YieldingMotion(const YieldingStoreys& storeys, double time_step);

  /// One step of time.
  /// @param ground0, ground1  acceleration of the ground at its begin and end [m/s2]
  void step(const Vector2& ground0, const Vector2& ground1);

  Vector2 floor_acceleration(Eigen::Index floor) const;     ///< absolute; 1 to n [m/s2]
  const Eigen::Matrix2Xd& drift() const { return drift_; }  ///< of each storey now [m]
  const StoreyEnergy& energy() const { return energy_; }

 private:
  struct Axis {
    Eigen::VectorXd stiffness, velocity, mean_velocity;
    Eigen::MatrixXd damping;
    SymmetricFactors solve;  ///< 2 M / h + C + h K / 2, with the elastic K
  };

  Axis axis_of(std::size_t a) const;
  /// Mean shear of all storeys over a step in which they drift by `increment` [m].
  Eigen::Matrix2Xd mean_shear(const Eigen::Matrix2Xd& increment);
  double shear(Eigen::Index storey, Eigen::Index a, double drift, double z) const;

  YieldingStoreys storeys_;
  double h_;
  std::array<Axis, 2> axes_;
  Eigen::Matrix2Xd drift_, z_, next_z_;
  StoreyEnergy energy_;
};

}  // namespace gurney::groundmotions
