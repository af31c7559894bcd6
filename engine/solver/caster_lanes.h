#pragma once

#include <array>

#include "engine/caster/contact_jacobian.h"
#include "engine/contact/tread_patch.h"
#include "engine/solver/mechanism.h"

namespace gurney {

/// Up to four casters of one item side by side in one implicit stage: what ItemStage needs of them.
/// Fewer than four casters are padded with the last one; padded lanes are never read.
class CasterLanes {
 public:
  /// @param first  index of its first caster in Mechanism::casters
  CasterLanes(const Mechanism& mechanism, std::size_t first);

  std::size_t first() const { return first_; }
  std::size_t count() const { return count_; }

  /// Moves the geometry to the end of the stage of length tau that `v` leads to.
  void update_geometry(const State& start, double tau, const Velocity& v, const Pose& pose,
                       const Vector3& gravity, bool first_pass);
  /// Mass moment, inertia by columns, bias; two entries are zero.
  std::array<Lanes, 20> inertia_and_bias() const;

  /// Forces at v and the residual of the joints.
  void evaluate_forces(const State& start, double tau, const Velocity& v,
                       const Vector6& chassis_change);
  /// Force on the chassis, then momentum.
  const std::array<Lanes, 12>& on_chassis() const { return on_chassis_; }
  /// The largest residual of a joint over the wheel's radius.
  double largest_joint_residual() const;
  /// Momentum of the chassis by the joint rates of v: their columns of M.
  Vec6<Lanes> joint_momentum(const Velocity& v) const {
    return coupled_momentum(joint_rates(v, 0), joint_rates(v, 1));
  }

  /// Newton's matrix of a caster in a stage of length tau [s],
  ///
  ///     K = M + tau J' D J = | A  B |  chassis: forces on it (N, N m) in a stage, by its velocity
  ///                          | C  E |  joints: moments on swivel and axle, by their rates
  ///
  /// an impulse by a velocity: kg, kg m and kg m2 in its blocks. M is the mass matrix
  /// (CasterGeometry), J the contact Jacobian (contact_jacobian.h) and D = -df/du >= 0 the slope of
  /// the tread's force (TreadSlope); E also has the slopes of bearing friction. Newton's step (x of
  /// the chassis, y of the joints) solves A x + B y = -r, C x + E y = -q with the residuals r and q
  /// [N s, N m s]. Eliminating y leaves the Schur complement of E for the chassis,
  ///
  ///     (A - B E^-1 C) x = -r + B E^-1 q,   y = -E^-1 (q + C x).
  ///
  /// @returns tau J' D J of the chassis, A without its mass, by columns; keeps B, C and E
  std::array<Lanes, 36> matrix(double tau);
  struct Elimination {
    std::array<Lanes, 36> matrix;     ///< -B E^-1 C, by columns
    std::array<Lanes, 8> right_side;  ///< B E^-1 q; the last two are zero
  };
  void eliminate();           ///< the matrix; it serves the residuals of later velocities too
  void eliminate_residual();  ///< the right side
  const Elimination& elimination() const { return elimination_; }
  /// Adds Newton's step y of the joints that goes with x of the chassis.
  void apply(const Vector6& step, Velocity& v) const;

  /// Sums over casters of what a finished stage did.
  struct Sums {
    EnergyAccount& power;
    double& spring_rates;
    Vector3& momentum;
  };
  struct Outputs {
    TreadLaw::Result* treads;
    Vector2* heading;
    Eigen::Vector2d* accelerations;
  };
  void finish(const State& start, double tau, const Velocity& v, const Vector6& acceleration,
              State& end, const Outputs& out, const Sums& sums) const;

  // One caster, by its lane.
  Vector3 swivel_axis(std::size_t k) const { return lane(geometry_.swivel_axis, k); }
  Vector3 axle(std::size_t k) const { return lane(geometry_.axle, k); }
  Vector3 mount(std::size_t k) const { return lane(geometry_.mount, k); }
  Vector3 wheel_center(std::size_t k) const { return lane(geometry_.wheel_center, k); }
  void keep(std::size_t k) { kept_[k] = -1; }
  bool kept(std::size_t k) const { return kept_[k] != 0; }
  Eigen::Vector2d joint_residual(std::size_t k) const;
  Matrix2 joints(std::size_t k) const;
  Eigen::Matrix<double, 6, 2> chassis_joints(std::size_t k) const;
  Eigen::Matrix<double, 2, 6> joints_chassis(std::size_t k) const;
  void add_joint_residual(std::size_t k, const Eigen::Vector2d& residual);
  void add_slopes(std::size_t k, const Eigen::Matrix<double, 6, 2>& chassis_joints,
                  const Eigen::Matrix<double, 2, 6>& joints_chassis, const Matrix2& joints);

 private:
  using JointVectors = std::array<Vec6<Lanes>, 2>;  // of swivel and axle
  static_assert(kMaxCasters % kLanes == 0, "joint_rates reads whole groups of casters");

  [[gnu::always_inline]] Lanes joint_rates(const Velocity& v, int joint) const {
    const Eigen::Vector2d* q = v.joints.data() + first_;
    return Lanes{q[0][joint], q[1][joint], q[2][joint], q[3][joint]};
  }
  Vec6<Lanes> coupled_momentum(const Lanes& swivel, const Lanes& axle) const;
  TreadRates<Lanes> rates_of(const Velocity& v) const;
  static void keep_result(const DryFrictionOf<Lanes>::Result& result,
                          DryFrictionOf<Lanes>::Result& kept);
  void set_swivel_angles(const State& start, double tau, const Velocity& v);

  std::size_t first_, count_;
  CasterConstants<Lanes> body_;
  TreadConstants<Lanes> tread_;
  DryFrictionOf<Lanes> swivel_, axle_;
  Lanes swivel_limit_{};
  std::array<const CasterDynamics*, kLanes> casters_{};

  // Where the stage ends and what acts there: update_geometry.
  CasterMotion<Lanes> motion_;
  std::array<double, kLanes> swivel_angles_{}, sines_{}, cosines_{};
  CasterGeometry<Lanes> geometry_;
  TreadStage<Lanes> stage_;
  TreadRates<Lanes> rates_;
  // At the velocity last asked for: evaluate_forces; then matrix and eliminate.
  TreadForce<Lanes> force_;
  TreadSlope<Lanes> slope_;
  Lanes swivel_wind_{}, axle_wind_{}, axle_limit_{};  // by the start of the stage
  DryFrictionOf<Lanes>::Result swivel_friction_, axle_friction_;
  std::array<Lanes, 2> joint_residual_{};                     // q
  std::array<std::array<Lanes, 2>, 2> joints_{}, inverse_{};  // E, E^-1, by columns
  JointVectors chassis_joints_{}, joints_chassis_{};          // columns of B, rows of C
  JointVectors taken_{};                                      // columns of B E^-1
  std::array<Lanes, 12> on_chassis_{};
  Elimination elimination_;
  LaneMask kept_{};
};

}  // namespace gurney
