#include "studies/verification/scenes/four_feet.h"

#include <algorithm>
#include <cmath>

namespace gurney {
namespace {

using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector2d, Eigen::Vector3d;

Quaterniond orientation(const FourFeet::Motion& y) {
  return Quaterniond(y[3], y[4], y[5], y[6]).normalized();
}

}  // namespace

FourFeet::Motion FourFeet::at_rest() const {
  Motion y = Motion::Zero();
  y[2] = radius - wheels[0].z() - mass * gravity / (4 * normal_stiffness);
  y[3] = 1;
  return y;
}

FourFeet::Foot FourFeet::foot(const Motion& y, const Matrix3d& rotation, std::size_t i) const {
  Foot foot;
  foot.axle = rotation.col(1);
  foot.rim = -radius * (Vector3d::UnitZ() - foot.axle.z() * foot.axle).normalized();
  foot.arm = rotation * wheels[i] + foot.rim;
  foot.depth = -(y[2] + foot.arm.z());
  return foot;
}

FourFeet::Motion FourFeet::rates(const Motion& y, const Vector3& floor) const {
  const Quaterniond q = orientation(y);
  const Matrix3d rotation = q.toRotationMatrix();
  const Vector3d v = y.segment<3>(7), w = y.segment<3>(10);
  Motion rate = Motion::Zero();
  rate.head<3>() = v;
  const Quaterniond turn = Quaterniond(0, w.x(), w.y(), w.z()) * q;
  rate.segment<4>(3) << 0.5 * turn.w(), 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z();

  Vector3d force = mass * (Vector3d(0, 0, -gravity) - floor), moment = Vector3d::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    const auto at = static_cast<Eigen::Index>(13 + 4 * i);
    const Foot f = foot(y, rotation, i);
    const double angle = y[at], spin = y[at + 1];
    const Vector3d u = v + w.cross(f.arm) + spin * f.axle.cross(f.rim);
    Vector3d push = Vector3d::Zero();
    Vector2d slip = Vector2d::Zero();
    if (f.depth > 0) {
      const double elastic = normal_stiffness * f.depth;
      const double normal = elastic + std::clamp(-normal_damping * u.z(), -elastic, elastic);
      const Vector2d e = y.segment<2>(at + 2), across = u.head<2>();
      Vector2d held = tangential_stiffness * e + tangential_damping * across;
      slip = across;
      if (held.norm() > friction * normal) {
        held *= friction * normal / held.norm();
        slip = (held - tangential_stiffness * e) / tangential_damping;
      }
      push << -held, normal;
    }
    const double torque = f.axle.dot(f.rim.cross(push)) - axle_stiffness * angle;
    rate[at] = spin;
    rate[at + 1] = torque / wheel_inertia;
    rate.segment<2>(at + 2) = slip;
    force += push;
    moment += f.arm.cross(push) - torque * f.axle;
  }
  rate.segment<3>(7) = force / mass;
  const Vector3d body_w = rotation.transpose() * w, body_moment = rotation.transpose() * moment;
  const Vector3d momentum = inertia.cwiseProduct(body_w);
  const Vector3d gain = (body_moment - body_w.cross(momentum)).cwiseQuotient(inertia);
  rate.segment<3>(10) = rotation * gain;
  return rate;
}

void FourFeet::step(Motion& y, double h, const std::array<Vector3, 3>& floor) const {
  const Motion a = rates(y, floor[0]), b = rates(y + 0.5 * h * a, floor[1]);
  const Motion c = rates(y + 0.5 * h * b, floor[1]), d = rates(y + h * c, floor[2]);
  y += h / 6 * (a + 2 * b + 2 * c + d);
  y.segment<4>(3).normalize();
  const Matrix3d rotation = orientation(y).toRotationMatrix();
  for (std::size_t i = 0; i < 4; ++i)
    if (foot(y, rotation, i).depth <= 0)
      y.segment<2>(static_cast<Eigen::Index>(15 + 4 * i)).setZero();
}

Eigen::Vector3d FourFeet::point(const Motion& y, const Vector3& from_centre) const {
  return y.head<3>() + orientation(y) * from_centre;
}

double FourFeet::tilt(const Motion& y) const {
  return std::acos(std::min(1.0, orientation(y).toRotationMatrix()(2, 2)));
}

int FourFeet::feet_on_floor(const Motion& y) const {
  const Matrix3d rotation = orientation(y).toRotationMatrix();
  int count = 0;
  for (std::size_t i = 0; i < 4; ++i) count += foot(y, rotation, i).depth > 0;
  return count;
}

}  // namespace gurney
