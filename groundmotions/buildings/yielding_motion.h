#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/base/linear_algebra.h"
#include "engine/base/vector.h"
#include "groundmotions/buildings/pinched_loop.h"

namespace gurney::groundmotions {

/// Floors that twist on storeys that yield, as in TorsionalBuilding: four columns carry a quarter of the
/// stiffness of their storey each, at (+-a, +-b) from its axis, so that K_t = K_x b^2 + K_y a^2.
struct YieldingTwist {
  Eigen::Matrix2Xd eccentricity;  ///< of the centre of mass of floors 1 to n [m]
  double gyration = 1;            ///< > 0 [m]
  Eigen::Matrix2Xd columns;       ///< a, b of each storey from the ground up >= 0, not both 0 [m]
  Eigen::VectorXd damping;        ///< of all 3 n elastic modes, by rising frequency, in [0, 1)
};

/// A shear building whose storeys yield. With d the drift of a column in h1 and h2, its shear is
///
///     V_a = alpha k_a d_a + (1 - alpha) k_a d_y z_a,   a = h1, h2
///     z' = d' / d_y inside the unit disc; on its edge without the part of d' that leads out of it
///
/// which is bilinear with kinematic hardening along one line, and yields at |d| = d_y in any direction. A
/// storey whose floors do not twist is one such column, k = K. With `pinching` V_a is a PinchedLoop of d_a, each
/// direction by itself. Strength does not degrade, and weight does no work on drift.
struct YieldingStoreys {
  Eigen::VectorXd mass;                      ///< of floors 1 to n > 0 [kg]; only ratios matter
  std::array<Eigen::VectorXd, 2> stiffness;  ///< K of each storey from the ground up > 0 [N/m]
  std::array<Eigen::VectorXd, 2> damping;  ///< of the elastic modes, by rising frequency, in [0, 1)
  Eigen::VectorXd yield_drift;             ///< d_y of each storey > 0 [m]
  double hardening = 0;                    ///< alpha in [0, 1)
  std::optional<Pinching> pinching = {};   ///< empty: loops are not pinched
  std::optional<YieldingTwist> twist = {};  ///< in place of `damping`; empty: floors do not twist
};

/// Energies relative to the ground, for the given masses [J]; every term comes from its own force.
struct StoreyEnergy {
  double input = 0;    ///< work of -a_ground
  double kinetic = 0;  ///< now
  double strain = 0;   ///< of alpha K d, now; of pinched loops V^2 / (2 K), all that can come back
  double hysteresis = 0;  ///< taken by z; (1 - alpha) K d_y^2 |z|^2 / 2 of it can come back
  double damping = 0;     ///< dissipated by the modes

  double closure() const { return input - kinetic - strain - hysteresis - damping; }
};

/// Its horizontal motions, solved together by the implicit midpoint rule:
///
///     M u'' + C u' + B' V(B u) = -M 1 a_ground,   C = sum_i 2 zeta_i omega_i M phi_i phi_i' M
///
/// with u the displacements of the floors at the axis of stiffness along h1 and h2, and r theta where they
/// twist; B takes them to the drifts of the columns, and phi_i' M phi_i = 1. Second order, stable for any step.
/// Drifts go straight in a step, so slide() and move() give the work of V exactly and the energies close to the
/// tolerance of the solve.
class YieldingMotion {
 public:
  /// @param time_step  > 0 [s]
  YieldingMotion(const YieldingStoreys& storeys, double time_step);

  /// One step of time.
  /// @param ground0, ground1  acceleration of the ground at its begin and end [m/s2]
  void step(const Vector2& ground0, const Vector2& ground1);

  /// Absolute acceleration of a place along h1 and h2 [m/s2], and yaw acceleration of its floor [rad/s2].
  /// @param floor  1 to n
  /// @param place  from the axis of stiffness [m]
  Vector3 floor_acceleration(Eigen::Index floor, const Vector2& place = Vector2::Zero()) const;
  double yaw(Eigen::Index floor) const;  ///< [rad]

  /// Drift of each storey at the axis along h1 and h2 [m], and its twist [rad], now.
  const Eigen::Matrix3Xd& drift() const { return drift_; }
  Eigen::VectorXd column_drift()
      const;  ///< |d| of the column of each storey where it is largest [m]
  const StoreyEnergy& energy() const { return energy_; }

 private:
  /// Coordinates that the elastic building couples: one row of all floors, or all three.
  struct Block {
    std::vector<Eigen::Index> rows;  ///< of 0, 1, 2: u_x, u_y, r theta
    Eigen::MatrixXd mass, damping;
    Eigen::MatrixXd carried;  ///< M 1: what a ground acceleration along h1, h2 pushes
    Eigen::VectorXd velocity, mean_velocity;
    SymmetricFactors solve;                         ///< 2 M / h + C + h K / 2, with the elastic K
    Eigen::VectorXd push{}, residual{}, scratch{};  ///< of one step
  };
  struct Column {
    Vector2 place;      ///< [m]
    Vector2 stiffness;  ///< [N/m]
    Vector2 z, next_z;
    std::array<PinchedLoop, 2> loops = {}, next_loops = {};  ///< in place of z
  };

  /// Mean force of a column over a way from `start`, which it ends at its next state.
  Vector2 mean_shear(Column& column, double yield, const Vector2& start, const Vector2& way) const;
  Vector2 shear(const Column& column, double yield, const Vector2& drift) const;  ///< now
  Block block_of(std::vector<Eigen::Index> rows) const;
  void find_increments();
  void find_mean_forces();
  void find_residual(Block& block) const;
  Vector3 force(Eigen::Index storey) const;  ///< now

  YieldingStoreys storeys_;
  double h_, gyration_;
  std::vector<std::vector<Column>> columns_;  ///< of each storey
  std::vector<Block> blocks_;
  Eigen::Matrix3Xd drift_;
  Eigen::Matrix3Xd increment_;   ///< of drift_ in a step at the mean velocities
  Eigen::Matrix3Xd mean_force_;  ///< of all storeys over this step: shears [N], torque [N m]
  StoreyEnergy energy_;
};

}  // namespace gurney::groundmotions
