#include "engine/caster/caster_dynamics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"

namespace gurney {
namespace {

/// Stuck bearings, brakes and locks are this much stiffer than the tread at their lever arm.
constexpr double kStickStiffnessRatio = 10;

/// Where a leaning wheel touches the floor: on the middle of its tread up to 10 degrees, from there
/// further out with every degree, on its edge from 30 degrees on (assumptions). A sharp edge would
/// have a valley between middle and edge in which no single contact point can stay.
constexpr double kCrownBegins = 10 * kRadiansPerDegree, kCrownEnds = 30 * kRadiansPerDegree;
const double kSineOfCrown = std::sin(kCrownBegins);

/// Nearer to its axle than this a direction has no part in the wheel's plane: sine of the angle.
constexpr double kSquare = 1e-6;

struct CrownPoint {
  double out;   ///< from the middle of the tread, along the axle [m]
  double drop;  ///< of the tread's radius there [m]
};

/// With out(lean) = (w/2) (lean - begin) / (end - begin), a convex tread whose slope at that point
/// is the lean has drop = integral of tan(lean) d out.
CrownPoint crown_point(double lean, double half_width) {
  const double per_radian = half_width / (kCrownEnds - kCrownBegins);
  const double until = std::min(lean, kCrownEnds);
  return {per_radian * (until - kCrownBegins),
          per_radian * std::log(std::cos(kCrownBegins) / std::cos(until))};
}

double stick_stiffness(const Caster& caster, double lever) {
  return kStickStiffnessRatio * caster.tread.tangential_stiffness * lever * lever;
}

}  // namespace

CasterDynamics::CasterDynamics(const Caster& caster, const Vector3& chassis_center)
    : tread_(caster.tread, caster.wheel_radius),
      axle_limit_(caster.axle.coulomb + caster.brake_torque),
      swivel_limit_(caster.swivel.coulomb + caster.swivel_lock_torque),
      swivels_(caster.swivels),
      braked_(caster.brake_torque > 0),
      turns_into_motion_(caster.swivels && caster.swivel_lock_torque == 0 &&
                         caster.trail > 0.02 * caster.wheel_radius),
      heading_(caster.heading),
      radius_(caster.wheel_radius),
      width_(caster.wheel_width),
      mass_(caster.fork_mass + caster.wheel_mass),
      axial_inertia_(caster.wheel_axial_inertia),
      mount_(caster.mount - chassis_center),
      wheel_center_(-caster.trail, 0, -(caster.height - caster.wheel_radius)) {
  axle_ = {stick_stiffness(caster, radius_), caster.axle.viscous};
  swivel_ = {stick_stiffness(caster, std::max(caster.trail, radius_)), caster.swivel.viscous};
  const double transverse = caster.wheel_transverse_inertia;
  MassProperties whole;
  whole.add(caster.fork_mass, caster.fork_center_of_mass, caster.fork_inertia);
  whole.add(caster.wheel_mass, wheel_center_,
            Vector3(transverse, axial_inertia_, transverse).asDiagonal());
  center_ = whole.center_of_mass;
  inertia_ = whole.inertia;
  swing_ = wheel_center_.norm() + std::hypot(radius_, caster.wheel_width / 2);
  reach_ = mount_.norm() + swing_;
}

std::array<Vector3, CasterDynamics::kRimPoints> CasterDynamics::rim(bool left) const {
  const double radius = radius_ - crown_point(kCrownEnds, 0.5 * width_).drop;
  std::array<Vector3, kRimPoints> points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kRimPoints;
    points[k] = wheel_center_ + Vector3(radius * std::cos(angle), (left ? 0.5 : -0.5) * width_,
                                        radius * std::sin(angle));
  }
  return points;
}

Vector3 CasterDynamics::tread_point(const Vector3& direction, const Vector3& found) const {
  const double sine = direction.y();
  const Vector3 in_plane(direction.x(), 0, direction.z());
  if (in_plane.norm() < kSquare) return found;
  const Vector3 outwards = in_plane.normalized();
  if (std::abs(sine) <= kSineOfCrown) return wheel_center_ + radius_ * outwards;
  const CrownPoint point = crown_point(std::asin(std::min(1.0, std::abs(sine))), 0.5 * width_);
  return wheel_center_ + (radius_ - point.drop) * outwards +
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

Vector3 CasterDynamics::center_of_mass(const Pose& pose, double swivel_angle) const {
  return pose.rotation * mount_ + fork_rotation(pose, swivel_angle) * center_;
}

void CasterDynamics::evaluate(const Pose& pose, double swivel_angle,
                              const Vector6& chassis_velocity, const Eigen::Vector2d& joint_rates,
                              const Vector3& gravity, Geometry& out) const {
  const Matrix3 fork = fork_rotation(pose, swivel_angle);
  const Vector3 s = fork.col(2), a = fork.col(1);
  out.swivel_axis = s;
  out.axle = a;
  out.mount = pose.rotation * mount_;
  const Vector3 arm = fork * wheel_center_;
  out.wheel_center = out.mount + arm;

  // The lowest point of the disc lies against the component of z in the wheel's plane.
  const Vector3 up = (Vector3::UnitZ() - a.z() * a).normalized();
  Vector3 down = -radius_ * up;
  if (std::abs(a.z()) > kSineOfCrown) {
    const CrownPoint point = crown_point(std::asin(std::min(1.0, std::abs(a.z()))), 0.5 * width_);
    down = (point.drop - radius_) * up - std::copysign(point.out, a.z()) * a;
  }
  out.contact = out.wheel_center + down;
  out.height = lies(a) ? 1 : pose.position.z() + out.contact.z();
  out.axle_level = Vector3(a.x(), a.y(), 0).normalized();
  out.heading = out.axle_level.cross(Vector3::UnitZ());

  // Inertia: momentum of the caster m v_L and J w_f + I_a theta' a about its centre.
  const Vector3 rho = fork * center_;
  const Vector3 r = out.mount + rho;
  const Matrix3 J = fork * inertia_ * fork.transpose();
  const double swivel = swivels_ ? 1.0 : 0.0;
  const Vector3 d = swivel * s.cross(rho);
  const Vector3 Js = swivel * (J * s);
  const Vector3 spin_momentum = axial_inertia_ * a;

  out.mass_chassis.topLeftCorner<3, 3>() = mass_ * Matrix3::Identity();
  Matrix3 rx;
  rx << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  out.mass_chassis.topRightCorner<3, 3>() = -mass_ * rx;
  out.mass_chassis.bottomLeftCorner<3, 3>() = mass_ * rx;
  out.mass_chassis.bottomRightCorner<3, 3>() = J - mass_ * rx * rx;
  out.mass_coupling.col(0) << mass_ * d, mass_ * r.cross(d) + Js;
  out.mass_coupling.col(1) << Vector3::Zero(), spin_momentum;
  out.mass_joints << (swivels_ ? mass_ * d.squaredNorm() + s.dot(Js) : 1.0),
      swivel * spin_momentum.dot(s), swivel * spin_momentum.dot(s), axial_inertia_;

  const Vector3 w = chassis_velocity.tail<3>();
  const double psi = swivel * joint_rates[0], theta = joint_rates[1];
  const Vector3 w_fork = w + psi * s;
  const Vector3 s_rate = w.cross(s);
  const Vector3 r_rate = w.cross(r) + psi * s.cross(rho);
  const Vector3 linear =
      mass_ * (w.cross(r_rate) + psi * (s_rate.cross(rho) + s.cross(w_fork.cross(rho))) - gravity);
  const Vector3 swivel_rate_change = psi * s_rate;
  const Vector3 angular =
      J * swivel_rate_change + w_fork.cross(J * w_fork) + theta * w_fork.cross(spin_momentum);
  out.bias_chassis << linear, r.cross(linear) + angular;
  out.bias_joints << d.dot(linear) + swivel * s.dot(angular), spin_momentum.dot(swivel_rate_change);

  auto& jc = out.jacobian_chassis;
  auto& jl = out.jacobian_joints;
  const Vector3& p = out.contact;
  const Vector3 swivel_speed = swivel * s.cross(arm + down);
  const Vector3 axle_speed = a.cross(down);
  const Vector3& level = out.axle_level;
  const double rs = tread_.spin_radius();
  jc << 1, 0, 0, 0, p.z(), -p.y(),  //
      0, 1, 0, -p.z(), 0, p.x(),    //
      0, 0, 1, p.y(), -p.x(), 0,    //
      0, 0, 0, 0, 0, rs,            //
      0, 0, 0, level.x(), level.y(), level.z();
  jl.topRows<3>() << swivel_speed, axle_speed;
  jl.row(3) << swivel * rs * s.z(), rs * a.z();
  jl.row(4) << swivel * s.dot(out.axle_level), a.dot(out.axle_level);
}

double CasterDynamics::kinetic_energy(const Geometry& g, const Vector6& v,
                                      const Eigen::Vector2d& rates) {
  return 0.5 * v.dot(g.mass_chassis * v) + v.dot(g.mass_coupling * rates) +
         0.5 * rates.dot(g.mass_joints * rates);
}

}  // namespace gurney
