#include "engine/solver/stage_solver.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/base/units.h"

namespace gurney {
namespace {

/// A stage is solved again when a direction it was built on has turned by more than this [rad].
/// What is left is second order in the step: the prediction misses by O(tau^2) where the motion is
/// smooth.
constexpr double kGeometryTolerance = 1e-3;
constexpr int kMaxGeometryPasses = 6;

constexpr int kMaxBacktracks = 6;
constexpr int kIterationsBeforeBacktracking = 4;

bool is_constrained(const Guide& guide) {
  return guide.kind == Guide::Kind::kHeld || guide.kind == Guide::Kind::kVelocity;
}

}  // namespace

StageSolver::StageSolver(const Mechanism& mechanism, const Settings& settings)
    : mechanism_(mechanism), settings_(settings) {}

void StageSolver::update_geometry(const Input& input, const Velocity& v, bool first) {
  const State& start = *input.start;
  const double tau = input.tau;
  predicted_ = v;
  pose_.position = start.position + tau * v.chassis.head<3>();
  pose_.rotation = rotated(tau * v.chassis.tail<3>(), start.rotation).toRotationMatrix();
  const Vector3 gravity = mechanism_.gravity - input.floor_acceleration;

  const auto& chassis = mechanism_.chassis;
  const Matrix3 inertia = pose_.rotation * chassis.inertia * pose_.rotation.transpose();
  const Vector3 w = v.chassis.tail<3>();
  mass_.setZero();
  mass_.diagonal().head<3>().setConstant(chassis.mass);
  mass_.bottomRightCorner<3, 3>() = inertia;
  bias_ << -chassis.mass * gravity, w.cross(inertia * w);

  for (std::size_t i = 0; i < mechanism_.legs.size(); ++i) {
    const Leg& leg = mechanism_.legs[i];
    LegWork& work = legs_[i];
    const double swivel = start.legs[i].swivel_angle + tau * v.joints[i][0];
    leg.evaluate(pose_, swivel, v.chassis, v.joints[i], gravity, work.g);
    mass_ += work.g.mass_chassis;
    bias_ += work.g.bias_chassis;
    const Vector5 u = work.g.jacobian_chassis * v.chassis + work.g.jacobian_joints * v.joints[i];
    work.tread.tau = tau;
    work.tread.compression = -work.g.height + tau * u[2];
    work.tread.start = start.legs[i].tread;
    const bool rolls = first ? start.legs[i].tread.rolling : std::abs(work.slope(4, 4)) == 0;
    work.tread.rolling_speed = rolls ? leg.wheel_radius() * std::abs(u[4]) : 0;
  }

  update_contacts(input, v);
}

double StageSolver::evaluate_forces(const Input& input, const Velocity& v) {
  const State& start = *input.start;
  const double tau = input.tau;
  Vector6 force = -bias_;
  const Vector6 chassis_change = v.chassis - start.velocity.chassis;
  Vector6 momentum = mass_ * chassis_change;
  double leg_residual = 0;
  for (std::size_t i = 0; i < mechanism_.legs.size(); ++i) {
    const Leg& leg = mechanism_.legs[i];
    LegWork& work = legs_[i];
    const Eigen::Vector2d& rates = v.joints[i];
    work.rates.noalias() = work.g.jacobian_chassis * v.chassis + work.g.jacobian_joints * rates;
    work.force = leg.tread().force(work.tread, work.rates, work.slope);
    work.swivel = leg.swivel_friction().evaluate(start.legs[i].swivel_wind, rates[0],
                                                 leg.swivel_limit(), tau);
    work.axle =
        leg.axle_friction().evaluate(start.legs[i].axle_wind, rates[1], leg.axle_limit(), tau);
    force.noalias() += work.g.jacobian_chassis.transpose() * work.force;
    const Eigen::Vector2d change = rates - start.velocity.joints[i];
    momentum.noalias() += work.g.mass_coupling * change;
    Eigen::Vector2d joint_force =
        work.g.jacobian_joints.transpose() * work.force - work.g.bias_joints;
    joint_force += Eigen::Vector2d(leg.swivels() ? work.swivel.torque : 0.0, work.axle.torque);
    work.joint_residual = work.g.mass_coupling.transpose() * chassis_change +
                          work.g.mass_joints * change - tau * joint_force;
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    ContactWork& work = contacts_[c];
    const BodyContact& contact = (*input.contacts)[c];
    work.force = work.law->force(work.stage, contact_rates(work, contact, v), work.slope);
    force.noalias() += work.jacobian_chassis.transpose() * work.force;
    if (contact.leg >= 0)
      legs_[static_cast<std::size_t>(contact.leg)].joint_residual -=
          tau * work.jacobian_joints.transpose() * work.force;
  }
  for (std::size_t i = 0; i < mechanism_.legs.size(); ++i)
    leg_residual = std::max(leg_residual, legs_[i].joint_residual.cwiseAbs().maxCoeff() /
                                              mechanism_.legs[i].wheel_radius());
  if (!mechanism_.loads.empty()) {
    mechanism_.loads.evaluate(input.loads, pose_, v.chassis, load_rows_);
    for (const auto& row : load_rows_) force += row.force * row.direction;
  }
  chassis_residual_ = momentum - tau * force;
  for (int dof = 0; dof < 6; ++dof) {
    const Guide& guide = mechanism_.fixture.guides[dof];
    if (!is_constrained(guide)) continue;
    reaction_[static_cast<std::size_t>(dof)] = chassis_residual_[dof];
    chassis_residual_[dof] = mechanism_.total_mass * (v.chassis[dof] - guide.velocity);
  }
  const double scale = 1 / (mechanism_.total_mass * kStandardGravity * tau);
  return scale * std::max({chassis_residual_.head<3>().cwiseAbs().maxCoeff(),
                           chassis_residual_.tail<3>().cwiseAbs().maxCoeff() / mechanism_.length,
                           leg_residual});
}

void StageSolver::newton_step(const Input& input, Velocity& v) {
  const double tau = input.tau;
  const std::size_t count = mechanism_.legs.size();
  Matrix6 K = mass_;
  Vector6 rhs = -chassis_residual_;
  std::array<Matrix2, kMaxLegs> k_joints;
  for (std::size_t i = 0; i < count; ++i) {
    LegWork& work = legs_[i];
    const auto& jc = work.g.jacobian_chassis;
    const auto& jl = work.g.jacobian_joints;
    const Eigen::Matrix<double, 5, 6> dc = tau * work.slope * jc;
    const Eigen::Matrix<double, 5, 2> dl = tau * work.slope * jl;
    K.noalias() += jc.transpose() * dc;
    work.k_chassis_joints = work.g.mass_coupling;
    work.k_chassis_joints.noalias() += jc.transpose() * dl;
    work.k_joints_chassis = work.g.mass_coupling.transpose();
    work.k_joints_chassis.noalias() += jl.transpose() * dc;
    k_joints[i] = work.g.mass_joints;
    k_joints[i].noalias() += jl.transpose() * dl;
    if (mechanism_.legs[i].swivels()) k_joints[i](0, 0) += tau * work.swivel.rate_slope;
    k_joints[i](1, 1) += tau * work.axle.rate_slope;
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const ContactWork& work = contacts_[c];
    const Matrix3 slope = tau * work.slope;
    K += work.jacobian_chassis.transpose() * slope * work.jacobian_chassis;
    const int leg = (*input.contacts)[c].leg;
    if (leg < 0) continue;
    LegWork& owner = legs_[static_cast<std::size_t>(leg)];
    owner.k_chassis_joints += work.jacobian_chassis.transpose() * slope * work.jacobian_joints;
    owner.k_joints_chassis += work.jacobian_joints.transpose() * slope * work.jacobian_chassis;
    k_joints[static_cast<std::size_t>(leg)] +=
        work.jacobian_joints.transpose() * slope * work.jacobian_joints;
  }
  for (const auto& row : load_rows_)
    if (row.slope != 0) K += tau * row.slope * row.direction * row.direction.transpose();

  for (std::size_t i = 0; i < count; ++i) {
    LegWork& work = legs_[i];
    work.k_inverse = k_joints[i].inverse();
    const Eigen::Matrix<double, 6, 2> eliminate = work.k_chassis_joints * work.k_inverse;
    K.noalias() -= eliminate * work.k_joints_chassis;
    rhs.noalias() += eliminate * work.joint_residual;
  }
  for (int dof = 0; dof < 6; ++dof) {
    if (!is_constrained(mechanism_.fixture.guides[dof])) continue;
    K.row(dof).setZero();
    K(dof, dof) = mechanism_.total_mass;
    rhs[dof] = -chassis_residual_[dof];
  }
  const Vector6 step = K.partialPivLu().solve(rhs);
  v.chassis += step;
  for (std::size_t i = 0; i < count; ++i)
    v.joints[i] -=
        legs_[i].k_inverse * (legs_[i].joint_residual + legs_[i].k_joints_chassis * step);
}

double StageSolver::geometry_error(const Input& input, const Velocity& v) const {
  double error = (v.chassis.tail<3>() - predicted_.chassis.tail<3>()).norm();
  for (std::size_t i = 0; i < mechanism_.legs.size(); ++i)
    error = std::max(error, std::abs(v.joints[i][0] - predicted_.joints[i][0]));
  return input.tau * error;
}

bool StageSolver::solve(const Input& input, Output& out) {
  Velocity v = input.guess;
  out.iterations = 0;
  bool converged = false;
  // Rounding of M v shows in the residual as M g tau gets small.
  const double rounding =
      1e-14 * (v.chassis.head<3>().norm() + 1e-3) / (kStandardGravity * input.tau);
  const double tolerance = settings_.residual + rounding;
  for (int pass = 0; pass < kMaxGeometryPasses; ++pass) {
    update_geometry(input, v, pass == 0);
    double residual = evaluate_forces(input, v);
    int iteration = 0;
    for (; residual > tolerance && iteration < settings_.max_iterations; ++iteration) {
      const Velocity before = v;
      newton_step(input, v);
      double next = evaluate_forces(input, v);
      if (iteration >= kIterationsBeforeBacktracking) {
        double fraction = 1;
        const Velocity full = v;
        for (int k = 0; k < kMaxBacktracks && !(next < residual); ++k) {
          fraction *= 0.5;
          v.chassis = before.chassis + fraction * (full.chassis - before.chassis);
          for (std::size_t i = 0; i < mechanism_.legs.size(); ++i)
            v.joints[i] = before.joints[i] + fraction * (full.joints[i] - before.joints[i]);
          next = evaluate_forces(input, v);
        }
      }
      residual = next;
      if (!std::isfinite(residual)) break;
    }
    out.iterations += iteration;
    out.residual = residual;
    converged = residual <= tolerance;
    if (!converged || geometry_error(input, v) < kGeometryTolerance) break;
  }
  if (std::isfinite(out.residual)) finish(input, v, out);
  return converged;
}

}  // namespace gurney
