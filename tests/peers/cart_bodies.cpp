#include "tests/peers/cart_bodies.h"

#include <algorithm>
#include <cmath>

namespace gurney::peers {
namespace {

Matrix3 cross_matrix(const Vector3& v) {
  Matrix3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Matrix3 about_z(double angle) {
  return Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
}

/// From the swivel axis at the top plate, in fork axes.
Vector3 wheel_center(const Caster& c) { return {-c.trail, 0, c.wheel_radius - c.height}; }

Matrix3 wheel_inertia(const Caster& c) {
  return Vector3(c.wheel_transverse_inertia, c.wheel_axial_inertia, c.wheel_transverse_inertia)
      .asDiagonal();
}

}  // namespace

/// Velocities v = V rates, w = W rates and accelerations V rates' + v_bias, W rates' + w_bias of a
/// point of a rigid body, with its mass and its inertia about that point in floor axes.
struct CartBodies::Body {
  Vector3 place, angular;
  RateRows v, w;
  Vector3 v_bias, w_bias;
  double mass = 0;
  Matrix3 inertia = Matrix3::Zero();
};

void CartState::move(double duration) {
  origin += duration * rates.head<3>();
  const Vector3 turn = duration * rates.segment<3>(3);
  if (turn.norm() > 0)
    rotation = Quaternion(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * rotation;
  rotation.normalize();
  joints += duration * rates.tail(joints.size());
}

CartBodies::CartBodies(const EquipmentModel& item, Held held)
    : casters_(item.casters), chassis_(chassis_with_payloads(item)) {
  long rows = 6;
  for (const Caster& c : casters_) {
    Joints joints;
    if (c.swivels) joints.swivel = rows++;
    if (held == Held::kBySprings || c.brake_torque == 0) joints.axle = rows++;
    joints_.push_back(joints);
  }
}

CartState CartBodies::at_rest() const {
  CartState state;
  long rows = 6;
  for (const Joints& j : joints_) rows = std::max({rows, j.swivel + 1, j.axle + 1});
  state.rates.setZero(rows);
  state.joints.setZero(rows - 6);
  for (std::size_t i = 0; i < casters_.size(); ++i)
    if (joints_[i].swivel >= 0) state.joints[joints_[i].swivel - 6] = casters_[i].heading;
  return state;
}

CartBodies::Body CartBodies::body_at(const Body& base, const Vector3& arm) {
  Body body = base;
  body.place += arm;
  body.v -= cross_matrix(arm) * base.w;
  body.v_bias += base.w_bias.cross(arm) + base.angular.cross(base.angular.cross(arm));
  return body;
}

/// Relative to the body it was, about an axis of that body.
void CartBodies::turn(Body& body, const Vector3& axis, long row, const CartState& state) {
  if (row < 0) return;
  const double rate = state.rates[row];
  body.w.col(row) = axis;
  body.w_bias += rate * body.angular.cross(axis);
  body.angular += rate * axis;
}

void CartBodies::add(const Body& body, const Vector3& gravity, Equations& out) {
  out.mass += body.mass * body.v.transpose() * body.v + body.w.transpose() * body.inertia * body.w;
  out.force += body.v.transpose() * (body.mass * (gravity - body.v_bias)) -
               body.w.transpose() *
                   (body.inertia * body.w_bias + body.angular.cross(body.inertia * body.angular));
}

void CartBodies::add_point(const Body& wheel, const Vector3& axle, double radius, Equations& out) {
  const Vector3 up = (Vector3::UnitZ() - axle.z() * axle).normalized();
  const Body lowest = body_at(wheel, -radius * up);
  const Vector3 level = Vector3(axle.x(), axle.y(), 0).normalized();
  WheelPoint point;
  point.compression = -lowest.place.z();
  point.jacobian.resize(4, lowest.v.cols());
  point.jacobian.topRows<3>() = lowest.v;
  point.jacobian.row(3) = level.transpose() * wheel.w;
  out.wheels.push_back(point);
}

void CartBodies::evaluate(const CartState& state, const Vector3& gravity, Equations& out) const {
  const long count = state.rates.size();
  out.mass.setZero(count, count);
  out.force.setZero(count);
  out.wheels.clear();
  const Matrix3 rotation = state.rotation.toRotationMatrix();
  Body base;
  base.place = state.origin;
  base.angular = state.rates.segment<3>(3);
  base.v.setZero(3, count);
  base.w.setZero(3, count);
  base.v.leftCols<3>().setIdentity();
  base.w.middleCols<3>(3).setIdentity();
  base.v_bias = base.w_bias = Vector3::Zero();
  const auto add_body = [&](const Body& at, double mass, const Matrix3& inertia,
                            const Matrix3& axes) {
    Body body = at;
    body.mass = mass;
    body.inertia = axes * inertia * axes.transpose();
    add(body, gravity, out);
  };
  add_body(body_at(base, rotation * chassis_.center_of_mass), chassis_.mass, chassis_.inertia,
           rotation);
  for (std::size_t i = 0; i < casters_.size(); ++i) {
    const Caster& c = casters_[i];
    const Joints& j = joints_[i];
    const double heading = j.swivel < 0 ? c.heading : state.joints[j.swivel - 6];
    const Matrix3 axes = rotation * about_z(heading);
    Body fork = body_at(base, rotation * c.mount);
    turn(fork, axes.col(2), j.swivel, state);
    add_body(body_at(fork, axes * c.fork_center_of_mass), c.fork_mass, c.fork_inertia, axes);
    Body wheel = body_at(fork, axes * wheel_center(c));
    turn(wheel, axes.col(1), j.axle, state);
    add_body(wheel, c.wheel_mass, wheel_inertia(c), axes);
    add_point(wheel, axes.col(1), c.wheel_radius, out);
  }
}

}  // namespace gurney::peers
