#pragma once

#include <array>
#include <vector>

#include "engine/solver/caster_lanes.h"
#include "engine/solver/floor_stage.h"
#include "engine/solver/mechanism.h"

namespace gurney {

/// J_a' D J_b of two chassis that touch at points a and b from their centres, with J = [1 -[p]x].
/// @param slope  D, floor axes
Matrix6 slope_between(const Matrix3& slope, const Vector3& a, const Vector3& b);

/// The equations of one item in one implicit stage of length tau (stage_solver.h),
///
///     M (v - v_start) = tau (J' f(J v) + f_loads(v) - bias),
///
/// their residual at v, and the matrix of Newton's method K = M + tau J' D J.
///
/// The item is a star: each caster touches only the chassis, so its two joints are eliminated and
/// one 6 x 6 system for the chassis is left. Casters that touch another item keep theirs.
class ItemStage {
 public:
  using Matrix36 = Eigen::Matrix<double, 3, 6>;
  using Matrix32 = Eigen::Matrix<double, 3, 2>;

  struct Input {
    const State* start = nullptr;  ///< pose, velocity and memory the stage starts from
    double tau = 0;
    FloorStage floor;
    Loads::Stage loads;
  };

  /// Dissipation and end of the stage, besides the new state and contacts.
  struct Output {
    Velocity acceleration;    ///< (v - v_start) / tau
    EnergyAccount power;      ///< work and loss entries in W
    double spring_rates = 0;  ///< a' M a + sum of k x'^2 [W/s]: for the numerical loss
    std::array<TreadLaw::Result, kMaxCasters> treads;
    std::array<Vector2, kMaxCasters> heading;
  };

  explicit ItemStage(const Mechanism& mechanism);

  /// Moves the geometry (M, J, bias) to the end of the stage that `v` leads to.
  void update_geometry(const Input& input, const Velocity& v, bool first);
  /// How far `v` turns a joint or the chassis from that geometry [rad].
  double geometry_error(const Velocity& v) const;

  /// The residual at v: begin, add every contact, end.
  void begin_forces(const Input& input, const Velocity& v);
  void add_contact_force(int caster, const Matrix36& chassis, const Matrix32& joints,
                         const Vector3& force);
  void add_moment(const Vector3& moment) { force_.tail<3>() += moment; }
  /// A force along a generalised direction of the chassis, of a joint; and its slope into K.
  void add_force(const Vector6& direction, double force) { force_ += force * direction; }
  void add_slope(const Vector6& direction, double slope) {
    const Vector6 scaled = tau_ * slope * direction;
    matrix_.noalias() += scaled * direction.transpose();
  }
  /// @returns the largest entry as a fraction of M g tau
  double end_forces(const Input& input, const Velocity& v);

  /// After end_forces(): M (v - v_start) - tau f, which a body that rides leaves to its carrier.
  const Vector6& residual() const { return residual_; }
  /// Takes over the residual of a body that rides at `arm` from the chassis' centre, and its K.
  void carry_residual(const Vector3& arm, const Vector6& residual);
  void carry_matrix(const Vector3& arm, const Matrix6& matrix);

  /// K at the last v: begin, add every contact, then eliminate the joints of casters not kept. Each
  /// residual, of this v or a later one, is then reduced alike.
  void begin_matrix();
  void keep(int caster) { lanes_of(caster).keep(lane_of(caster)); }
  /// Adds tau J' D J of the chassis; and beside it what a contact on a wheel has, tau D its slope.
  void add_slope(const Matrix6& slope) { matrix_ += slope; }
  void add_turning_slope(const Matrix3& slope) { matrix_.bottomRightCorner<3, 3>() += slope; }
  void add_joint_slope(int caster, const Matrix36& chassis, const Matrix32& joints,
                       const Matrix3& slope);
  void eliminate();
  void eliminate_residual();

  /// Applies Newton's step of the chassis, and with it those of the eliminated joints.
  void apply(const Vector6& step, Velocity& v) const;

  void finish(const Input& input, const Velocity& v, State& end, Output& out) const;

  const Mechanism& mechanism() const { return mechanism_; }
  const Pose& pose() const { return pose_; }
  bool kept(int caster) const { return lanes_of(caster).kept(lane_of(caster)); }
  /// The lanes of a caster, and which of them is its.
  const CasterLanes& lanes_of(int caster) const {
    return casters_[static_cast<std::size_t>(caster) / kLanes];
  }
  static std::size_t lane_of(int caster) { return static_cast<std::size_t>(caster) % kLanes; }
  /// After elimination: of the chassis, K and the negative residual.
  const Matrix6& matrix() const { return matrix_; }
  const Vector6& right_side() const { return right_side_; }
  bool constrained(int dof) const;

 private:
  CasterLanes& lanes_of(int caster) { return casters_[static_cast<std::size_t>(caster) / kLanes]; }
  /// Momentum of the chassis and its load, linear and about its centre.
  Vector6 all_momentum(const Velocity& v) const;

  const Mechanism& mechanism_;
  std::vector<CasterLanes> casters_;
  std::vector<Loads::Row> load_rows_;
  double tau_ = 0;
  Pose pose_;           // predicted end of the stage
  Velocity predicted_;  // the velocity that leads there
  Matrix6 mass_ = Matrix6::Zero(), matrix_;
  Vector6 carried_;  // acceleration that a rotating floor gives the chassis
  Vector6 bias_, momentum_, force_, residual_, right_side_;
  std::array<double, 6> reaction_{};  // of guides, impulse
};

}  // namespace gurney
