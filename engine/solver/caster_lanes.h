#pragma once

#include <array>

#include "engine/caster/contact_jacobian.h"
#include "engine/contact/tread_patch.h"
#include "engine/solver/mechanism.h"

namespace gurney {

/// Up to four casters of one item side by side in one implicit stage: what ItemStage needs of them.
/// Of fewer than four the last one fills the lanes left, which are never read.
class CasterLanes {
 public:
  using Six = std::array<Lanes, 6>;

  /// @param first  index of its first caster in Mechanism::casters
  CasterLanes(const Mechanism& mechanism, std::size_t first);

  std::size_t first() const { return first_; }
  std::size_t count() const { return count_; }

  /// Moves the geometry to the end of the stage of length tau that `v` leads to.
  void update_geometry(const State& start, double tau, const Velocity& v, const Pose& pose,
                       const Vector3& gravity, bool first_pass);
  /// Moment of mass, inertia by columns, bias; two entries are zero.
  std::array<Lanes, 20> inertia_and_bias() const;

  /// Forces at v and the residual of the joints.
  void evaluate_forces(const State& start, double tau, const Velocity& v,
                       const Vector6& chassis_change);
  /// Force on the chassis, then momentum.
  const std::array<Lanes, 12>& on_chassis() const { return on_chassis_; }
  /// The largest residual of a joint over the wheel's radius.
  double largest_joint_residual() const;
  /// M of chassis and joints times the joint rates of v.
  Six joint_momentum(const Velocity& v) const {
    return coupled_momentum(joint_rates(v, 0), joint_rates(v, 1));
  }

  /// J' D J of the chassis by columns; keeps what belongs to the joints.
  std::array<Lanes, 36> matrix(double tau);
  /// What takes the joints out of the chassis' matrix, by columns, and of its right side; two
  /// entries of that are zero.
  struct Elimination {
    std::array<Lanes, 36> matrix;
    std::array<Lanes, 8> right_side;
  };
  void eliminate();
  const Elimination& elimination() const { return elimination_; }
  /// Newton's step of the joints that goes with one of the chassis.
  void apply(const Vector6& step, Velocity& v) const;

  /// Sums over casters of what a finished stage did.
  struct Sums {
    EnergyAccount& power;
    double& spring_rates;
    Vector3& momentum;
  };
  struct Outputs {
    TreadLaw::Result* treads;
    bool* axle_slips;
    Vector2* heading;
    Eigen::Vector2d* accelerations;
  };
  void finish(const State& start, double tau, const Velocity& v, const Vector6& acceleration,
              State& end, const Outputs& out, const Sums& sums) const;

  // One caster, by its lane.
  Vector3 swivel_axis(std::size_t lane) const { return of_lane(geometry_.swivel_axis, lane); }
  Vector3 axle(std::size_t lane) const { return of_lane(geometry_.axle, lane); }
  Vector3 mount(std::size_t lane) const { return of_lane(geometry_.mount, lane); }
  Vector3 wheel_center(std::size_t lane) const { return of_lane(geometry_.wheel_center, lane); }
  void keep(std::size_t lane) { kept_[lane] = -1; }
  bool kept(std::size_t lane) const { return kept_[lane] != 0; }
  Eigen::Vector2d joint_residual(std::size_t lane) const;
  Matrix2 joints(std::size_t lane) const;
  Eigen::Matrix<double, 6, 2> chassis_joints(std::size_t lane) const;
  Eigen::Matrix<double, 2, 6> joints_chassis(std::size_t lane) const;
  void add_joint_residual(std::size_t lane, const Eigen::Vector2d& residual);
  void add_slopes(std::size_t lane, const Eigen::Matrix<double, 6, 2>& chassis_joints,
                  const Eigen::Matrix<double, 2, 6>& joints_chassis, const Matrix2& joints);

 private:
  using SixByTwo = std::array<Six, 2>;  // by columns, or of 2 x 6 by rows

  [[gnu::always_inline]] Lanes joint_rates(const Velocity& v, int joint) const {
    const Eigen::Vector2d* q = v.joints.data() + first_;
    return Lanes{q[0][joint], q[1][joint], q[2][joint], q[3][joint]};
  }
  Six coupled_momentum(const Lanes& swivel, const Lanes& axle) const;
  ContactRates<Lanes> rates_of(const Velocity& v) const;
  static void keep_result(const DryFrictionOf<Lanes>::Result& result,
                          DryFrictionOf<Lanes>::Result& kept);
  void set_swivel_angles(const State& start, double tau, const Velocity& v);

  std::size_t first_, count_;
  CasterConstants<Lanes> body_;
  TreadConstants<Lanes> tread_;
  DryFrictionOf<Lanes> swivel_, axle_;
  Lanes swivel_limit_{}, axle_limit_{};
  std::array<const TreadLaw*, kLanes> laws_{};

  CasterMotion<Lanes> motion_;
  std::array<double, kLanes> swivel_angles_{}, sines_{}, cosines_{};
  CasterGeometry<Lanes> geometry_;
  TreadStage<Lanes> stage_;
  ContactRates<Lanes> rates_;
  TreadForce<Lanes> force_;
  TreadSlope<Lanes> slope_;
  Lanes swivel_wind_{}, axle_wind_{};  // at the start of the stage
  DryFrictionOf<Lanes>::Result swivel_friction_, axle_friction_;
  std::array<Lanes, 2> joint_residual_{};
  std::array<std::array<Lanes, 2>, 2> joints_{}, inverse_{};  // by columns
  SixByTwo chassis_joints_{}, joints_chassis_{};
  std::array<Lanes, 12> on_chassis_{};
  Elimination elimination_;
  LaneMask kept_{};
};

}  // namespace gurney
