#include "engine/solver/item_stage.h"

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"

namespace gurney {

Matrix6 slope_between(const Matrix3& slope, const Vector3& a, const Vector3& b) {
  // | D        -D [b]x      |,  and d' [b]x = -(b x d)' for a row d'.
  // | [a]x D   -[a]x D [b]x |
  Matrix6 between;
  between.topLeftCorner<3, 3>() = slope;
  for (int k = 0; k < 3; ++k) between.block<3, 1>(3, k) = a.cross(slope.col(k));
  for (int k = 0; k < 6; ++k)
    between.block<1, 3>(k, 3) = b.cross(between.block<1, 3>(k, 0).transpose()).transpose();
  return between;
}

// Sums go from numbers of Eigen's to lanes and back. What was just written number by number is read
// as lanes after the casters' turn: at once, the processor would wait for it.

ItemStage::ItemStage(const Mechanism& mechanism) : mechanism_(mechanism) {
  for (std::size_t first = 0; first < mechanism.casters.size(); first += kLanes)
    casters_.emplace_back(mechanism, first);
  double mass = mechanism.chassis.mass;
  for (const CasterDynamics& caster : mechanism.casters) mass += caster.mass();
  mass_.topLeftCorner<3, 3>() = mass * Matrix3::Identity();
}

bool ItemStage::constrained(int dof) const {
  const Guide::Kind kind = mechanism_.fixture.guides[dof].kind;
  return kind == Guide::Kind::kHeld || kind == Guide::Kind::kVelocity;
}

void ItemStage::update_geometry(const Input& input, const Velocity& v, bool first) {
  const State& start = *input.start;
  const double tau = input.tau;
  tau_ = tau;
  predicted_ = v;
  pose_.position = start.position + tau * v.chassis.head<3>();
  pose_.rotation = rotated(tau * v.chassis.tail<3>(), start.rotation).toRotationMatrix();
  // In axes that move with the floor its acceleration acts as a change of gravity on every mass.
  const Vector3 gravity = mechanism_.gravity - input.floor.acceleration;
  carried_ << input.floor.angular_acceleration.cross(pose_.position),
      input.floor.angular_acceleration;

  const auto& chassis = mechanism_.chassis;
  // Newton-Euler of the chassis about its centre: bias = (-m g, w x I w).
  const Matrix3 inertia = pose_.rotation * chassis.inertia * pose_.rotation.transpose();
  const Vector3 w = v.chassis.tail<3>();
  std::array<double, 20> sums{};  // moment of mass, inertia by columns, bias
  Eigen::Map<Matrix3> inertia_sum(&sums[3]);
  Eigen::Map<Vector6> bias_sum(&sums[12]);
  inertia_sum = inertia;
  bias_sum << -chassis.mass * gravity, w.cross(inertia * w);
  for (CasterLanes& lanes : casters_) lanes.update_geometry(start, tau, v, pose_, gravity, first);
  auto packed = loaded<5>(sums.data());
  for (const CasterLanes& lanes : casters_)
    add_lanes(lanes.inertia_and_bias().data(), lanes.count(), packed);
  store(packed, sums.data());
  // M = | m 1  -[s] |   with s the moment of mass about the chassis' centre, to which the chassis adds nothing,
  //     | [s]   I  |   and [s] x = s x x.
  Matrix3 moment;
  moment << 0, -sums[2], sums[1], sums[2], 0, -sums[0], -sums[1], sums[0], 0;
  mass_.topRightCorner<3, 3>() = -moment;
  mass_.bottomLeftCorner<3, 3>() = moment;
  mass_.bottomRightCorner<3, 3>() = inertia_sum;
  bias_ = bias_sum;
}

double ItemStage::geometry_error(const Velocity& v) const {
  double error = (v.chassis.tail<3>() - predicted_.chassis.tail<3>()).norm();
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i)
    error = std::max(error, std::abs(v.joints[i][0] - predicted_.joints[i][0]));
  return tau_ * error;
}

void ItemStage::begin_forces(const Input& input, const Velocity& v) {
  const State& start = *input.start;
  const double tau = input.tau;
  // Change of velocity in the stage against an unaccelerated observer; a floor that turns carries its axes along.
  Vector6 chassis_change = v.chassis - start.velocity.chassis;
  if (input.floor.rotates) chassis_change += tau * carried_;
  std::array<double, 12> sums;
  Eigen::Map<Vector6> force(&sums[0]), momentum(&sums[6]);
  force = -bias_;
  momentum = mass_ * chassis_change;
  for (CasterLanes& lanes : casters_) lanes.evaluate_forces(start, tau, v, chassis_change);
  auto packed = loaded<3>(sums.data());
  for (const CasterLanes& lanes : casters_)
    add_lanes(lanes.on_chassis().data(), lanes.count(), packed);
  store(packed, sums.data());
  force_ = force;
  momentum_ = momentum;
}

void ItemStage::add_contact_force(int caster, const Matrix36& chassis, const Matrix32& joints,
                                  const Vector3& force) {
  force_.noalias() += chassis.transpose() * force;
  if (caster >= 0)
    lanes_of(caster).add_joint_residual(lane_of(caster), -tau_ * joints.transpose() * force);
}

void ItemStage::carry_residual(const Vector3& arm, const Vector6& residual) {
  // T' r, with T' = | 1    0 |;  the residual is -tau times what force_ sums.
  //                 | [s]x 1 |
  force_.head<3>() -= residual.head<3>() / tau_;
  force_.tail<3>() -= (arm.cross(residual.head<3>()) + residual.tail<3>()) / tau_;
}

void ItemStage::carry_matrix(const Vector3& arm, const Matrix6& matrix) {
  // T' K T by columns, then by rows: d' [s]x = -(s x d)'.
  Matrix6 carried = matrix;
  for (int k = 0; k < 6; ++k) carried.block<3, 1>(3, k) += arm.cross(matrix.block<3, 1>(0, k));
  for (int k = 0; k < 6; ++k)
    carried.block<1, 3>(k, 3) += arm.cross(carried.block<1, 3>(k, 0).transpose()).transpose();
  matrix_ += carried;
}

double ItemStage::end_forces(const Input& input, const Velocity& v) {
  const double tau = input.tau;
  load_rows_.clear();
  if (!mechanism_.loads.empty())
    mechanism_.loads.evaluate(input.loads, pose_, v.chassis, load_rows_);
  if (!mechanism_.tethers.empty())
    mechanism_.tethers.evaluate(tau, *input.start, pose_, v.chassis, load_rows_);
  for (const auto& row : load_rows_) force_ += row.force * row.direction;
  // r = M (v - v_start) - tau (J' f + f_loads - bias).
  residual_ = momentum_ - tau * force_;
  for (int dof = 0; dof < 6; ++dof) {
    if (!constrained(dof)) continue;
    // A guide replaces the equation of its direction by v = v_guide; what the equation misses is its impulse.
    reaction_[static_cast<std::size_t>(dof)] = residual_[dof];
    residual_[dof] =
        mechanism_.total_mass * (v.chassis[dof] - mechanism_.fixture.guides[dof].velocity);
  }
  double joints = 0;
  for (const CasterLanes& lanes : casters_)
    joints = larger_or_nan(joints, lanes.largest_joint_residual());
  // Residuals as fractions of the impulse of the weight; those of moments over a length of the item.
  const double scale = 1 / (mechanism_.total_mass * kStandardGravity * tau);
  const auto largest = [&](int first) {
    return residual_.segment<3>(first).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  };
  return scale * larger_or_nan(larger_or_nan(largest(0), largest(3) / mechanism_.length), joints);
}

void ItemStage::begin_matrix() {
  auto sums = loaded<9>(mass_.data());
  for (CasterLanes& lanes : casters_) add_lanes(lanes.matrix(tau_).data(), lanes.count(), sums);
  store(sums, matrix_.data());
}

void ItemStage::add_joint_slope(int caster, const Matrix36& chassis, const Matrix32& joints,
                                const Matrix3& slope) {
  lanes_of(caster).add_slopes(lane_of(caster), chassis.transpose() * slope * joints,
                              joints.transpose() * slope * chassis,
                              joints.transpose() * slope * joints);
}

void ItemStage::eliminate() {
  for (const auto& row : load_rows_)
    if (row.slope != 0) matrix_ += tau_ * row.slope * row.direction * row.direction.transpose();
  // The Schur complement A - B E^-1 C of all casters (CasterLanes::matrix).
  for (CasterLanes& lanes : casters_) lanes.eliminate();
  auto matrix = loaded<9>(matrix_.data());
  for (const CasterLanes& lanes : casters_)
    add_lanes(lanes.elimination().matrix.data(), lanes.count(), matrix);
  store(matrix, matrix_.data());
  for (int dof = 0; dof < 6; ++dof) {
    if (!constrained(dof)) continue;
    // m (v + x) = m v_guide for the step x.
    matrix_.row(dof).setZero();
    matrix_(dof, dof) = mechanism_.total_mass;
  }
}

void ItemStage::eliminate_residual() {
  // -r + B E^-1 q, but for directions whose equation a guide replaces.
  std::array<double, 8> side{};
  Eigen::Map<Vector6>(side.data()) = -residual_;
  for (CasterLanes& lanes : casters_) lanes.eliminate_residual();
  auto right_side = loaded<2>(side.data());
  for (const CasterLanes& lanes : casters_)
    add_lanes(lanes.elimination().right_side.data(), lanes.count(), right_side);
  store(right_side, side.data());
  right_side_ = Eigen::Map<Vector6>(side.data());
  for (int dof = 0; dof < 6; ++dof)
    if (constrained(dof)) right_side_[dof] = -residual_[dof];
}

void ItemStage::apply(const Vector6& step, Velocity& v) const {
  v.chassis += step;
  for (const CasterLanes& lanes : casters_) lanes.apply(step, v);
}

}  // namespace gurney
