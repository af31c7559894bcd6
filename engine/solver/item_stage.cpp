#include "engine/solver/item_stage.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/base/units.h"

namespace gurney {
namespace {

using Matrix58 = Eigen::Matrix<double, 5, 8>;
using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// a b, the five products of every entry summed in pairs, by columns: eight sums at once.
Matrix8 product(const ItemStage::Matrix85& a, const Matrix58& b) {
  Matrix8 result;
  for (int j = 0; j < 8; ++j)
    result.col(j) = (a.col(0) * b(0, j) + a.col(2) * b(2, j)) +
                    (a.col(1) * b(1, j) + a.col(3) * b(3, j)) + a.col(4) * b(4, j);
  return result;
}

}  // namespace

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
  const Vector3 gravity = mechanism_.gravity - input.floor.acceleration;
  carried_ << input.floor.angular_acceleration.cross(pose_.position),
      input.floor.angular_acceleration;

  const auto& chassis = mechanism_.chassis;
  const Matrix3 inertia = pose_.rotation * chassis.inertia * pose_.rotation.transpose();
  const Vector3 w = v.chassis.tail<3>();
  mass_.topLeftCorner<3, 3>() = chassis.mass * Matrix3::Identity();
  mass_.topRightCorner<3, 3>().setZero();
  mass_.bottomLeftCorner<3, 3>().setZero();
  mass_.bottomRightCorner<3, 3>() = inertia;
  bias_ << -chassis.mass * gravity, w.cross(inertia * w);

  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i) {
    const CasterDynamics& caster = mechanism_.casters[i];
    CasterWork& work = casters_[i];
    work.kept = false;
    const double swivel = start.casters[i].swivel_angle + tau * v.joints[i][0];
    caster.evaluate(pose_, swivel, v.chassis, v.joints[i], gravity, work.g);
    mass_ += work.g.mass_chassis;
    bias_ += work.g.bias_chassis;
    work.jacobian_transposed.topRows<6>() = work.g.jacobian_chassis.transpose();
    work.jacobian_transposed.bottomRows<2>() = work.g.jacobian_joints.transpose();
    const Vector5 u = work.g.jacobian_chassis * v.chassis + work.g.jacobian_joints * v.joints[i];
    work.tread.tau = tau;
    work.tread.compression = -work.g.height + tau * u[2];
    work.tread.start = start.casters[i].tread;
    const bool rolls = first ? start.casters[i].tread.rolling : std::abs(work.slope(4, 4)) == 0;
    work.tread.rolling_speed = rolls ? caster.wheel_radius() * std::abs(u[4]) : 0;
  }
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
  force_ = -bias_;
  Vector6 chassis_change = v.chassis - start.velocity.chassis;
  if (input.floor.rotates) chassis_change += tau * carried_;
  momentum_ = mass_ * chassis_change;
  // Laws first, then sums: a vector read right after it is written makes the processor wait.
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i) {
    const CasterDynamics& caster = mechanism_.casters[i];
    CasterWork& work = casters_[i];
    const Eigen::Vector2d& rates = v.joints[i];
    work.rates.noalias() = work.g.jacobian_chassis * v.chassis + work.g.jacobian_joints * rates;
    work.force = caster.tread().force(work.tread, work.rates, work.slope);
    work.swivel = caster.swivel_friction().evaluate(start.casters[i].swivel_wind, rates[0],
                                                    caster.swivel_limit(), tau);
    work.axle = caster.axle_friction().evaluate(start.casters[i].axle_wind, rates[1],
                                                caster.axle_limit(), tau);
  }
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i) {
    CasterWork& work = casters_[i];
    force_.noalias() += work.g.jacobian_chassis.transpose() * work.force;
    const Eigen::Vector2d change = v.joints[i] - start.velocity.joints[i];
    momentum_.noalias() += work.g.mass_coupling * change;
    const Eigen::Vector2d momentum = work.g.mass_joints * change;
    const double torques[2] = {mechanism_.casters[i].swivels() ? work.swivel.torque : 0.0,
                               work.axle.torque};
    for (int k = 0; k < 2; ++k) {
      const double joint_force =
          work.g.jacobian_joints.col(k).dot(work.force) - work.g.bias_joints[k] + torques[k];
      work.joint_residual[k] =
          work.g.mass_coupling.col(k).dot(chassis_change) + momentum[k] - tau * joint_force;
    }
  }
}

void ItemStage::add_contact_force(int caster, const Matrix36& chassis, const Matrix32& joints,
                                  const Vector3& force) {
  force_.noalias() += chassis.transpose() * force;
  if (caster >= 0)
    casters_[static_cast<std::size_t>(caster)].joint_residual -= tau_ * joints.transpose() * force;
}

double ItemStage::end_forces(const Input& input, const Velocity& v) {
  const double tau = input.tau;
  load_rows_.clear();
  if (!mechanism_.loads.empty())
    mechanism_.loads.evaluate(input.loads, pose_, v.chassis, load_rows_);
  if (!mechanism_.tethers.empty())
    mechanism_.tethers.evaluate(tau, *input.start, pose_, v.chassis, load_rows_);
  for (const auto& row : load_rows_) force_ += row.force * row.direction;
  residual_ = momentum_ - tau * force_;
  for (int dof = 0; dof < 6; ++dof) {
    if (!constrained(dof)) continue;
    reaction_[static_cast<std::size_t>(dof)] = residual_[dof];
    residual_[dof] =
        mechanism_.total_mass * (v.chassis[dof] - mechanism_.fixture.guides[dof].velocity);
  }
  double joints = 0;
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i)
    joints = std::max(joints, casters_[i].joint_residual.cwiseAbs().maxCoeff() /
                                  mechanism_.casters[i].wheel_radius());
  const double scale = 1 / (mechanism_.total_mass * kStandardGravity * tau);
  return scale * std::max({residual_.head<3>().cwiseAbs().maxCoeff(),
                           residual_.tail<3>().cwiseAbs().maxCoeff() / mechanism_.length, joints});
}

void ItemStage::begin_matrix() {
  matrix_ = mass_;
  // All slopes first: a matrix read right after it is written makes the processor wait.
  std::array<Matrix5, kMaxCasters> slopes;
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i) slopes[i] = tau_ * casters_[i].slope;
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i) {
    const CasterDynamics& caster = mechanism_.casters[i];
    CasterWork& work = casters_[i];
    const Matrix5& slope = slopes[i];
    Matrix58 forces;
    forces.leftCols<3>() = slope.leftCols<3>();  // the contact point moves with the chassis
    forces.middleCols<3>(3).noalias() = slope * work.g.jacobian_chassis.rightCols<3>();
    forces.rightCols<2>().noalias() = slope * work.g.jacobian_joints;
    const Matrix8 added = product(work.jacobian_transposed, forces);
    matrix_ += added.topLeftCorner<6, 6>();
    work.k_chassis_joints = work.g.mass_coupling + added.topRightCorner<6, 2>();
    work.k_joints_chassis = work.g.mass_coupling.transpose() + added.bottomLeftCorner<2, 6>();
    work.k_joints = work.g.mass_joints + added.bottomRightCorner<2, 2>();
    if (caster.swivels()) work.k_joints(0, 0) += tau_ * work.swivel.rate_slope;
    work.k_joints(1, 1) += tau_ * work.axle.rate_slope;
  }
}

void ItemStage::add_contact_slope(int caster, const Matrix36& chassis, const Matrix32& joints,
                                  const Matrix3& slope) {
  matrix_ += chassis.transpose() * slope * chassis;
  if (caster < 0) return;
  CasterWork& owner = casters_[static_cast<std::size_t>(caster)];
  owner.k_chassis_joints += chassis.transpose() * slope * joints;
  owner.k_joints_chassis += joints.transpose() * slope * chassis;
  owner.k_joints += joints.transpose() * slope * joints;
}

void ItemStage::eliminate() {
  right_side_ = -residual_;
  for (const auto& row : load_rows_)
    if (row.slope != 0) matrix_ += tau_ * row.slope * row.direction * row.direction.transpose();
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i) {
    CasterWork& work = casters_[i];
    if (work.kept) continue;
    work.k_inverse = work.k_joints.inverse();
    const Eigen::Matrix<double, 6, 2> eliminated = work.k_chassis_joints * work.k_inverse;
    matrix_.noalias() -= eliminated * work.k_joints_chassis;
    right_side_.noalias() += eliminated * work.joint_residual;
  }
  for (int dof = 0; dof < 6; ++dof) {
    if (!constrained(dof)) continue;
    matrix_.row(dof).setZero();
    matrix_(dof, dof) = mechanism_.total_mass;
    right_side_[dof] = -residual_[dof];
  }
}

void ItemStage::apply(const Vector6& step, Velocity& v) const {
  v.chassis += step;
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i) {
    const CasterWork& work = casters_[i];
    if (work.kept) continue;
    v.joints[i] -= work.k_inverse * (work.joint_residual + work.k_joints_chassis * step);
  }
}

}  // namespace gurney
