#include "engine/caster/caster_dynamics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"

namespace gurney {
namespace {

/// Angle from which a leaning wheel touches the floor with the edge of its tread. Up to
/// kCrownBegins it touches with the middle, between the two further out with every degree
/// (assumptions). A sharp edge would have a valley between middle and edge in which no single
/// contact point can stay.
constexpr double kCrownEnds = 30 * kRadiansPerDegree;

/// Nearer to its axle than this a direction has no part in the wheel's plane: sine of the angle.
constexpr double kSquare = 1e-6;

struct CrownPoint {
  double out;   ///< from the middle of the tread, along the axle [m]
  double drop;  ///< of the tread's radius there [m]
};

/// Point of a crowned tread under a leaning wheel. With out(lean) = (w/2) (lean - begin) /
/// (end - begin), a convex tread whose slope at that point is the lean has drop = integral of
/// tan(lean) d out.
CrownPoint crown_point(double lean, double half_width) {
  const double per_radian = half_width / (kCrownEnds - kCrownBegins);
  const double until = std::min(lean, kCrownEnds);
  return {per_radian * (until - kCrownBegins),
          per_radian * std::log(std::cos(kCrownBegins) / std::cos(until))};
}

/// Stiffness of stuck bearings, brakes and locks, whose load acts through the tread at a lever arm.
double stick_stiffness(const Caster& caster, double lever) {
  return kStickStiffnessRatio * caster.tread.tangential_stiffness * lever * lever;
}

}  // namespace

CasterDynamics::CasterDynamics(const Caster& caster, const Vector3& chassis_center)
    : tread_(caster.tread, caster.wheel_radius),
      axle_limit_(caster.axle.coulomb + caster.brake_torque),
      sliding_axle_limit_(caster.axle.coulomb + caster.brake_sliding_ratio * caster.brake_torque),
      swivel_limit_(caster.swivel.coulomb + caster.swivel_lock_torque),
      braked_(caster.brake_torque > 0),
      turns_into_motion_(caster.swivels && caster.swivel_lock_torque == 0 &&
                         caster.trail > 0.02 * caster.wheel_radius),
      heading_(caster.heading),
      mount_(caster.mount - chassis_center),
      wheel_center_(-caster.trail, 0, -(caster.height - caster.wheel_radius)) {
  const double radius = caster.wheel_radius;
  axle_ = {stick_stiffness(caster, radius), caster.axle.viscous};
  swivel_ = {stick_stiffness(caster, std::max(caster.trail, radius)), caster.swivel.viscous};
  const double transverse = caster.wheel_transverse_inertia;
  MassProperties whole;
  whole.add(caster.fork_mass, caster.fork_center_of_mass, caster.fork_inertia);
  whole.add(caster.wheel_mass, wheel_center_,
            Vector3(transverse, caster.wheel_axial_inertia, transverse).asDiagonal());
  center_ = whole.center_of_mass;
  swing_ = wheel_center_.norm() + std::hypot(radius, caster.wheel_width / 2);
  reach_ = mount_.norm() + swing_;
  constants_ = {caster.fork_mass + caster.wheel_mass,
                caster.wheel_axial_inertia,
                radius,
                caster.wheel_width,
                caster.swivels ? 1.0 : 0.0,
                tread_.spin_radius(),
                splat<double>(mount_),
                splat<double>(wheel_center_),
                splat<double>(center_),
                splat<double>(whole.inertia)};
}

Vector3 crown_contact(double axle_z, double radius, double width, const Vector3& up,
                      const Vector3& axle) {
  const CrownPoint point = crown_point(std::asin(std::min(1.0, std::abs(axle_z))), 0.5 * width);
  return (point.drop - radius) * up - std::copysign(point.out, axle_z) * axle;
}

std::array<Vector3, CasterDynamics::kRimPoints> CasterDynamics::rim(bool left) const {
  const double half_width = 0.5 * wheel_width();
  const double radius = wheel_radius() - crown_point(kCrownEnds, half_width).drop;
  std::array<Vector3, kRimPoints> points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kRimPoints;
    points[k] = wheel_center_ + Vector3(radius * std::cos(angle), left ? half_width : -half_width,
                                        radius * std::sin(angle));
  }
  return points;
}

Vector3 CasterDynamics::tread_point(const Vector3& direction, const Vector3& found) const {
  const double sine = direction.y();
  const Vector3 in_plane(direction.x(), 0, direction.z());
  if (in_plane.norm() < kSquare) return found;
  const Vector3 outwards = in_plane.normalized();
  if (std::abs(sine) <= kSineOfCrown) return wheel_center_ + wheel_radius() * outwards;
  const CrownPoint point =
      crown_point(std::asin(std::min(1.0, std::abs(sine))), 0.5 * wheel_width());
  return wheel_center_ + (wheel_radius() - point.drop) * outwards +
         std::copysign(point.out, sine) * Vector3::UnitY();
}

Vector3 CasterDynamics::tread_point(const Pose& pose, double swivel_angle, const Vector3& outwards,
                                    const Vector3& found) const {
  const Matrix3 fork = fork_rotation(pose, swivel_angle);
  return pose.rotation * mount_ + fork * tread_point(fork.transpose() * outwards, found);
}

Matrix3 CasterDynamics::fork_rotation(const Pose& pose, double swivel_angle) const {
  const double c = std::cos(swivel_angle), s = std::sin(swivel_angle);
  Matrix3 fork;
  fork << c, -s, 0, s, c, 0, 0, 0, 1;
  return pose.rotation * fork;
}

CasterGeometry<double> CasterDynamics::contact(const Pose& pose, double swivel_angle) const {
  CasterMotion<double> motion;
  motion.rotation = splat<double>(pose.rotation);
  motion.height = pose.position.z();
  motion.sine = std::sin(swivel_angle);
  motion.cosine = std::cos(swivel_angle);
  CasterGeometry<double> g;
  contact_geometry(constants_, motion, g);
  return g;
}

}  // namespace gurney
