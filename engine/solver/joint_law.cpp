#include "engine/solver/joint_law.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/solver/cord_law.h"

namespace gurney {
namespace {

using JointKind = gurney::Joint::Kind;

/// The law of a stop: stiffness and restitution, without friction.
ContactConstants stop_of(const Joint& joint) {
  return {ContactConstants::Kind::kRestitution, joint.stop_stiffness, joint.restitution, 0, 0};
}

/// The rotation vector of R: its axis times its angle.
Vector3 rotation_vector(const Matrix3& rotation) {
  const Quaternion q(rotation);
  const Vector3 v = (q.w() < 0 ? -1.0 : 1.0) * q.vec();
  const double sine = v.norm();
  if (sine < 1e-12) return 2 * v;
  return 2 * std::atan2(sine, std::abs(q.w())) / sine * v;
}

/// J^T with dtheta/dt = J w for the angular velocity w that turns a body of the rotation vector theta,
///   J = 1 - [theta] / 2 + (1 / a^2 - (1 + cos a) / (2 a sin a)) [theta]^2,   a = |theta|,
/// the inverse of w = (1 + (1 - cos a) / a^2 [theta] + (a - sin a) / a^3 [theta]^2) dtheta/dt.
Matrix3 transposed_rate_matrix(const Vector3& theta) {
  const double angle = theta.norm();
  const double quadratic =
      angle < 1e-3 ? 1.0 / 12
                   : 1 / (angle * angle) - (1 + std::cos(angle)) / (2 * angle * std::sin(angle));
  Matrix3 cross;
  cross << 0, -theta.z(), theta.y(), theta.z(), 0, -theta.x(), -theta.y(), theta.x(), 0;
  return Matrix3::Identity() + 0.5 * cross + quadratic * cross * cross;
}

}  // namespace

JointLaw::JointLaw(const Joint& joint, const Mechanism& base, const Mechanism& part, double carried)
    : joint_(joint),
      on_base_(joint.point - base.chassis.center_of_mass),
      on_part_(joint.point - part.chassis.center_of_mass),
      hold_(carried * kHoldFrequency * kHoldFrequency),
      stop_(stop_of(joint)) {
  frame_.col(2) = joint.axis;
  frame_.col(0) = joint.axis.unitOrthogonal();
  frame_.col(1) = joint.axis.cross(frame_.col(0));
  const double largest =
      Eigen::SelfAdjointEigenSolver<Matrix3>(part.chassis.inertia).eigenvalues().maxCoeff();
  // Squared radius of gyration about the joint: the same omega_c for rotations.
  hold_turn_ = hold_ * (largest / part.chassis.mass + on_part_.squaredNorm());
  friction_.stiffness = joint.friction / kYield;
}

JointLaw::JointLaw(const Tether& tether, std::size_t index, const Mechanism& anchor_item,
                   const Mechanism& item)
    : on_base_(tether.anchor - anchor_item.chassis.center_of_mass),
      on_part_(tether.point - item.chassis.center_of_mass),
      stop_(stop_of(joint_)),
      cord_(tether),
      tether_index_(index) {
  joint_.kind = JointKind::kBall;
  joint_.base = *tether.anchor_item;
  joint_.part = tether.item;
  joint_.latch = tether.strength;
}

JointState JointLaw::initial_state() const {
  JointState state;
  state.latched = joint_.latch > 0;
  return state;
}

JointLaw::Rows JointLaw::rows(const Pose& base, const Pose& part, double turn) const {
  if (cord_) return cord_rows(base, part);
  Rows result;
  const Matrix3 frame = base.rotation * frame_;
  const Vector3 arm = part.rotation * on_part_;  // of the part's point
  const Vector3 from_base = part.position + arm - base.position;
  const Vector3 apart = from_base - base.rotation * on_base_;
  const auto add = [&](double value, bool free, double hold) -> Row& {
    Row& row = result.rows[result.count++];
    row.value = value;
    row.stiffness = free ? joint_.stiffness : hold;
    row.damping = free ? joint_.damping : hold * kHoldTime;
    row.holds = !free;
    return row;
  };
  for (int k = 0; k < 3; ++k) {
    const Vector3 d = frame.col(k);
    const bool free = slides() && k == 2;
    if (free) result.along = result.count;
    Row& row = add(d.dot(apart), free, hold_);
    row.part << d, arm.cross(d);
    row.base << d, from_base.cross(d);
  }
  const auto turning = [](const Vector3& d, Row& row) {
    row.part << Vector3::Zero(), d;
    row.base = row.part;
  };
  const Matrix3 relative = base.rotation.transpose() * part.rotation;
  // A hinge holds its axis a: e_k = f_k . a with the axes f_k across it, and f_k . (w x a) = w . (a x f_k).
  if (joint_.kind == JointKind::kHinge) {
    const Vector3 axis = relative * joint_.axis;
    for (int k = 0; k < 2; ++k)
      turning(base.rotation * axis.cross(frame_.col(k)),
              add(frame_.col(k).dot(axis), false, hold_turn_));
    const Vector3 across = relative * frame_.col(0);
    const double angle = std::atan2(frame_.col(1).dot(across), frame_.col(0).dot(across));
    result.along = result.count;
    turning(frame.col(2), add(turn + std::remainder(angle - turn, 2 * std::numbers::pi), true, 0));
    return result;
  }
  // A ball without a spring damps w itself, however far it has turned.
  if (joint_.kind == JointKind::kBall && joint_.stiffness == 0) {
    for (int k = 0; k < 3 && joint_.damping > 0; ++k) turning(frame.col(k), add(0, true, 0));
    return result;
  }
  // All other rotations are held, or spring, by the rotation vector theta with theta_k' = (J' f_k) . w.
  const Vector3 theta = rotation_vector(relative);
  const Matrix3 to_rates = transposed_rate_matrix(theta);
  for (int k = 0; k < 3; ++k) {
    const bool free =
        joint_.kind == JointKind::kBall || (joint_.kind == JointKind::kFlexible && k < 2);
    // A row without any force.
    if (free && joint_.stiffness == 0 && joint_.damping == 0) continue;
    turning(base.rotation * to_rates * frame_.col(k),
            add(frame_.col(k).dot(theta), free, hold_turn_));
  }
  return result;
}

JointLaw::Rows JointLaw::cord_rows(const Pose& base, const Pose& part) const {
  Rows result;
  const Vector3 arm = part.rotation * on_part_, base_arm = base.rotation * on_base_;
  const Vector3 towards = base.position + base_arm - part.position - arm;
  const auto add = [&](const Vector3& direction) -> Row& {
    Row& row = result.rows[result.count++];
    // T pulls the part along the direction: it feels -T d_p.
    row.part << -direction, -arm.cross(direction);
    row.base << -direction, -base_arm.cross(direction);
    return row;
  };
  add(towards.normalized()).value = towards.norm() - cord_->slack_length;
  if (cord_->slack_pull > 0) add(slack_direction(towards));
  return result;
}

/// Leaves the stretch at the end as the coordinate, and the tension as the wind.
double JointLaw::finish_cord(const Stage& stage, const std::array<double, kRows>& rates,
                             EnergyAccount& power, JointState& end) const {
  end = stage.start;
  const double rate = rates[0];
  end.coordinate = stage.rows.rows[0].value + stage.tau * rate;
  end.wind = 0;
  if (!stage.start.latched) return 0;
  const CordForce force = cord_force(*cord_, end.coordinate, rate, stage.tau);
  end.wind = force.sum();
  power.damper_loss += force.damping * rate;
  if (stage.rows.count > 1) power.work_of_forces -= cord_->slack_pull * rates[1];
  return force.elastic > 0 ? cord_->stiffness * rate * rate : 0;
}

ImpactLaw::Stage JointLaw::at_stop(const Stage& stage, int side) const {
  const double q = stage.rows.rows[*stage.rows.along].value;
  ImpactLaw::Stage at;
  at.tau = stage.tau;
  at.ahead = stage.ahead;
  at.turned = (side == 0 ? 1 : -1) * (stage.start.coordinate - q);
  at.compression = side == 0 ? joint_.lower - q : q - joint_.upper;
  at.approach_speed = stage.start.approach[static_cast<std::size_t>(side)];
  return at;
}

JointLaw::Force JointLaw::along(const Stage& stage, double rate) const {
  const Row& row = stage.rows.rows[*stage.rows.along];
  const double tau = stage.tau, q = row.value + tau * rate;
  Force sum;
  // All that acts along q adds up, each at the end of the stage.
  sum.force = row.stiffness * (q - joint_.rest) + row.damping * rate;
  sum.slope = tau * row.stiffness + row.damping;
  if (joint_.friction > 0) {
    const auto friction = friction_.evaluate(stage.start.wind, rate, joint_.friction, tau);
    sum.force -= friction.torque;
    sum.slope += friction.rate_slope;
  }
  if (stage.start.latched) {
    const double k = latch_stiffness(), c = k * kHoldTime;
    sum.force += k * (q - stage.start.latched_at) + c * rate;
    sum.slope += tau * k + c;
  }
  for (int side = 0; side < 2; ++side) {
    if (std::isinf(side == 0 ? joint_.lower : joint_.upper)) continue;
    const double away = side == 0 ? 1 : -1;
    Matrix3 slope;
    const Vector3 push = stop_.force(at_stop(stage, side), {0, 0, away * rate}, slope);
    sum.force -= away * push.z();
    sum.slope += slope(2, 2);
  }
  return sum;
}

JointLaw::Force JointLaw::force(const Stage& stage, std::size_t index, double rate) const {
  if (cord_) {
    if (!stage.start.latched) return {};
    if (index == 1) return {cord_->slack_pull, 0};
    const CordForce force =
        cord_force(*cord_, stage.rows.rows[0].value + stage.tau * rate, rate, stage.tau);
    return {force.sum(), force.slope};
  }
  if (index == stage.rows.along) return along(stage, rate);
  const Row& row = stage.rows.rows[index];
  return {row.stiffness * (row.value + stage.tau * rate) + row.damping * rate,
          stage.tau * row.stiffness + row.damping};
}

double JointLaw::finish(const Stage& stage, const std::array<double, kRows>& rates,
                        EnergyAccount& power, JointState& end) const {
  if (cord_) return finish_cord(stage, rates, power, end);
  double spring_rates = 0;
  for (std::size_t i = 0; i < stage.rows.count; ++i) {
    const Row& row = stage.rows.rows[i];
    if (row.holds) {
      power.numerical_loss += force(stage, i, rates[i]).force * rates[i];
      continue;
    }
    power.damper_loss += row.damping * rates[i] * rates[i];
    spring_rates += row.stiffness * rates[i] * rates[i];
  }
  end = stage.start;
  if (!stage.rows.along) return spring_rates;
  const double rate = rates[*stage.rows.along], tau = stage.tau;
  end.coordinate = stage.rows.rows[*stage.rows.along].value + tau * rate;
  if (joint_.friction > 0) {
    end.wind = friction_.evaluate(stage.start.wind, rate, joint_.friction, tau).deflection;
    const double winding = (end.wind - stage.start.wind) / tau;
    power.damper_loss += friction_.stiffness * end.wind * (rate - winding);
    spring_rates += friction_.stiffness * winding * winding;
  }
  if (stage.start.latched) {
    const double k = latch_stiffness();
    if (locked()) {
      const double yield = end.coordinate - stage.start.latched_at;
      power.numerical_loss += k * (yield + kHoldTime * rate) * rate;
    } else {
      power.damper_loss += k * kHoldTime * rate * rate;
      spring_rates += k * rate * rate;
    }
  }
  for (int side = 0; side < 2; ++side) {
    if (std::isinf(side == 0 ? joint_.lower : joint_.upper)) continue;
    const ImpactLaw::Stage at = at_stop(stage, side);
    const Vector3 u(0, 0, side == 0 ? rate : -rate);
    Matrix3 slope;
    const ImpactLaw::Result result = stop_.finish(at, u, stop_.force(at, u, slope));
    power.contact_loss += result.damping_power;
    spring_rates += result.spring_rates;
  }
  return spring_rates;
}

double JointLaw::along(const Pose& base, const Pose& part, const Vector6& wrench) const {
  const Vector3 axis = base.rotation * joint_.axis, force = wrench.head<3>();
  if (slides()) return axis.dot(force);
  return axis.dot(wrench.tail<3>() - (part.rotation * on_part_).cross(force));
}

Vector6 JointLaw::shift(const Pose& base, const Pose& part, double by) const {
  const Vector3 moved = by * (base.rotation * joint_.axis);
  Vector6 shift;
  if (slides())
    shift << moved, Vector3::Zero();
  else
    shift << (part.rotation * on_part_).cross(moved), moved;
  return shift;
}

JointState JointLaw::yielded(const JointState& state, double along) const {
  JointState end = state;
  // A force as long as none of the laws changes, which it does at few places.
  constexpr int kMaxIterations = 20;
  for (int i = 0; i < kMaxIterations; ++i) {
    const double wound = state.wind + end.coordinate - state.coordinate;
    end.wind = joint_.friction > 0 ? std::clamp(wound, -kYield, kYield) : 0;
    double force =
        latch_stiffness() * (end.coordinate - state.latched_at) + friction_.stiffness * end.wind;
    double slope = latch_stiffness() + (end.wind == wound ? friction_.stiffness : 0);
    for (const auto& [compression, away] :
         {std::pair{joint_.lower - end.coordinate, 1.0}, {end.coordinate - joint_.upper, -1.0}})
      if (compression > 0) {
        force -= away * joint_.stop_stiffness * compression;
        slope += joint_.stop_stiffness;
      }
    // Where friction that was wound up the other way loads the latch beyond its strength, it lets go in the next step.
    constexpr double kLeast = 0.999 * kYield;
    const double before = end.coordinate;
    end.coordinate = std::clamp(before - (along + force) / slope, state.latched_at - kLeast,
                                state.latched_at + kLeast);
    if (std::abs(end.coordinate - before) < 1e-12) break;
  }
  return end;
}

double JointLaw::past_release(const JointState& state) const {
  if (!state.latched || !releases()) return -1;
  if (cord_) return (state.wind - cord_->strength) / cord_->stiffness;
  return std::abs(state.coordinate - state.latched_at) - kYield;
}

double JointLaw::work_latch(double rate, JointState& state) const {
  if (!releases()) return 0;
  if (cord_) {
    if (past_release(state) < -kReleaseDistance) return 0;
    state.latched = false;
    const double stretch = std::max(state.coordinate, 0.0);
    return 0.5 * cord_->stiffness * stretch * stretch;
  }
  if (!state.latched) {
    if (joint_.relatches && std::abs(state.coordinate) < kCatchRange &&
        std::abs(rate) < kCatchSpeed) {
      state.latched = true;
      state.latched_at = state.coordinate;
    }
    return 0;
  }
  if (past_release(state) < -kReleaseDistance) return 0;
  const double yield = state.coordinate - state.latched_at;
  state.latched = false;
  return 0.5 * latch_stiffness() * yield * yield;
}

double JointLaw::stored_energy(const Rows& rows, const JointState& state) const {
  if (cord_) {
    const double stretch = state.latched ? std::max(rows.rows[0].value, 0.0) : 0;
    return 0.5 * cord_->stiffness * stretch * stretch;
  }
  double energy = 0.5 * friction_.stiffness * state.wind * state.wind;
  for (std::size_t i = 0; i < rows.count; ++i) {
    const Row& row = rows.rows[i];
    if (row.holds) continue;
    const double stretch = row.value - (i == rows.along ? joint_.rest : 0);
    energy += 0.5 * row.stiffness * stretch * stretch;
  }
  if (!rows.along) return energy;
  const double q = rows.rows[*rows.along].value;
  if (state.latched && !locked())
    energy += 0.5 * latch_stiffness() * (q - state.latched_at) * (q - state.latched_at);
  return energy + stop_.stored_energy(joint_.lower - q, 0) +
         stop_.stored_energy(q - joint_.upper, 0);
}

std::array<JointLaw::Approach, 2> JointLaw::approaches(const JointState& state, double rate) const {
  return {{{joint_.lower - state.coordinate, -rate}, {state.coordinate - joint_.upper, rate}}};
}

}  // namespace gurney
