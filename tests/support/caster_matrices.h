#pragma once

#include <Eigen/Core>
#include <cmath>

#include "engine/caster/caster_dynamics.h"

namespace gurney {

/// Blocks of the mass matrix, bias and contact Jacobian of a caster: caster_geometry() and contact_rates() as
/// dense matrices.
struct CasterMatrices {
  Vector3 swivel_axis;
  Vector3 axle;          ///< unit, to the left
  Vector3 heading;       ///< horizontal rolling direction, unit
  Vector3 axle_level;    ///< horizontal direction of the axle, unit
  Vector3 mount;         ///< relative to O
  Vector3 wheel_center;  ///< relative to O
  /// Lowest point of the undeformed wheel, relative to O: on the middle of the tread up to a lean
  /// of 10 degrees, from there towards its edge, which is reached at 30 degrees.
  Vector3 contact;
  double height = 0;  ///< of that point above the floor (negative: compressed); 1 when it lies [m]

  Matrix6 mass_chassis;                       ///< added to the chassis
  Eigen::Matrix<double, 6, 2> mass_coupling;  ///< chassis x joints
  Matrix2 mass_joints;
  Vector6
      bias_chassis;  ///< forces at zero acceleration: inertia (Coriolis, gyroscopic) minus weight
  Eigen::Vector2d bias_joints;
  Eigen::Matrix<double, 5, 6> jacobian_chassis;  ///< contact rates u = Jc V + Jl q'
  Eigen::Matrix<double, 5, 2> jacobian_joints;
};

/// @param gravity  acceleration that acts on every mass: gravity minus that of the floor [m/s2]
inline CasterMatrices caster_matrices(const CasterDynamics& caster, const Pose& pose,
                                      double swivel_angle, const Vector6& chassis_velocity,
                                      const Eigen::Vector2d& joint_rates, const Vector3& gravity) {
  const CasterConstants<double>& constants = caster.constants();
  CasterMatrices out;
  CasterGeometry<double> g;
  caster_geometry<double>(
      constants,
      {splat<double>(pose.rotation), pose.position.z(), std::sin(swivel_angle),
       std::cos(swivel_angle), splat<double>(Vector3(chassis_velocity.tail<3>())), joint_rates[0],
       joint_rates[1], splat<double>(gravity)},
      g);
  const auto vector = [](const Vec3<double>& v) -> Vector3 { return {v.x, v.y, v.z}; };
  const auto cross_matrix = [](const Vec3<double>& v) {
    Matrix3 m;
    m << 0, -v.z, v.y, v.z, 0, -v.x, -v.y, v.x, 0;
    return m;
  };
  out.swivel_axis = vector(g.swivel_axis);
  out.axle = vector(g.axle);
  out.mount = vector(g.mount);
  out.wheel_center = vector(g.wheel_center);
  out.contact = vector(g.contact);
  out.height = g.height;
  out.axle_level = vector(g.axle_level);
  out.heading = out.axle_level.cross(Vector3::UnitZ());

  out.mass_chassis << constants.mass * Matrix3::Identity(), -cross_matrix(g.mass_moment),
      cross_matrix(g.mass_moment), Matrix3::Zero();
  out.mass_chassis.bottomRightCorner<3, 3>() << vector(g.inertia.x), vector(g.inertia.y),
      vector(g.inertia.z);
  out.mass_coupling << vector(g.coupling_linear), Vector3::Zero(), vector(g.coupling_angular),
      vector(g.spin_momentum);
  out.mass_joints << g.joint_inertia, g.joint_coupling, g.joint_coupling, constants.axial_inertia;
  out.bias_chassis << vector(g.bias_linear), vector(g.bias_angular);
  out.bias_joints << g.bias_swivel, g.bias_axle;
  out.jacobian_chassis << Matrix3::Identity(), -cross_matrix(g.contact),
      Vector3::Zero().transpose(), Vector3(0, 0, constants.spin_radius).transpose(),
      Vector3::Zero().transpose(), out.axle_level.transpose();
  out.jacobian_joints << vector(g.swivel_speed), vector(g.axle_speed), g.swivel_spin, g.axle_spin,
      g.swivel_roll, g.axle_roll;
  return out;
}

}  // namespace gurney
