#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "engine/base/vector.h"
#include "engine/caster/caster_geometry.h"
#include "engine/contact/dry_friction.h"
#include "engine/contact/tread_law.h"
#include "engine/scene/equipment_model.h"

namespace gurney {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Pose of the chassis: its centre of mass O and the rotation from chassis to floor axes.
struct Pose {
  Vector3 position = Vector3::Zero();
  Matrix3 rotation = Matrix3::Identity();
};

/// One caster as part of the mechanism: two joints (swivel, axle) on the chassis. The fork with the
/// wheel is one rigid body that swivels (the wheel is axisymmetric); the spin adds the momentum
/// I_a w a along the axle.
///
/// Velocities: V = (velocity of O, angular velocity), floor axes; joint rates q' = (swivel, axle).
class CasterDynamics {
 public:
  /// @param chassis_center  O in item axes
  CasterDynamics(const Caster& caster, const Vector3& chassis_center);

  /// Geometry of the contact with the floor: contact_geometry().
  CasterGeometry<double> contact(const Pose& pose, double swivel_angle) const;

  /// A point of the fork (fork axes, relative to the mount), relative to O in floor axes.
  Vector3 point(const Pose& pose, double swivel_angle, const Vector3& on_fork) const {
    return pose.rotation * mount_ + fork_rotation(pose, swivel_angle) * on_fork;
  }
  /// Fork axes, relative to the mount, of a point relative to O in floor axes.
  Vector3 on_fork(const Pose& pose, double swivel_angle, const Vector3& point) const {
    return fork_rotation(pose, swivel_angle).transpose() * (point - pose.rotation * mount_);
  }

  /// Whether a wheel with this axle lies on its side, more than 60 degrees from upright: it then
  /// has no contact on its tread.
  static bool lies(const Vector3& axle) { return std::abs(axle.z()) > kSineOfLying; }

  /// A direction in fork axes.
  Vector3 across(const Pose& pose, double swivel_angle, const Vector3& direction) const {
    return fork_rotation(pose, swivel_angle).transpose() * direction;
  }

  static constexpr int kRimPoints = 12;
  /// Contact points of a wheel that lies on its side: on the edge of its tread, left or right. Fork
  /// axes, relative to the mount.
  std::array<Vector3, kRimPoints> rim(bool left) const;

  /// Where the crowned tread touches a plane that faces `direction` (unit, outwards, fork axes); of
  /// one that faces its side squarely, `found`. Fork axes, relative to the mount.
  Vector3 tread_point(const Vector3& direction, const Vector3& found) const;

  /// Point of the tread in floor axes, relative to O; `found` in fork axes.
  Vector3 tread_point(const Pose& pose, double swivel_angle, const Vector3& outwards,
                      const Vector3& found) const;

  const TreadLaw& tread() const { return tread_; }
  const DryFriction& axle_friction() const { return axle_; }
  const DryFriction& swivel_friction() const { return swivel_; }
  /// Largest dry torque of the axle: of a brake what it holds until it slips, and less from then until
  /// it sticks again [N m].
  double axle_limit(bool slips) const { return slips ? sliding_axle_limit_ : axle_limit_; }
  double swivel_limit() const { return swivel_limit_; }
  bool swivels() const { return constants_.swivels != 0; }
  /// Whether a free swivel follows the motion at the start: it has a trail to speak of and no lock.
  bool turns_into_motion() const { return turns_into_motion_; }
  bool braked() const { return braked_; }
  const CasterConstants<double>& constants() const { return constants_; }
  double mass() const { return constants_.mass; }
  double wheel_radius() const { return constants_.radius; }
  double wheel_width() const { return constants_.width; }
  const Vector3& wheel_center() const { return wheel_center_; }  ///< fork axes, from the mount
  double heading() const { return heading_; }
  double swing() const {
    return swing_;
  }  ///< largest distance of any of its points from the mount [m]
  double reach() const { return reach_; }  ///< largest distance of any of its points from O [m]

 private:
  Matrix3 fork_rotation(const Pose& pose, double swivel_angle) const;

  TreadLaw tread_;
  DryFriction axle_, swivel_;
  double axle_limit_, sliding_axle_limit_, swivel_limit_;
  bool braked_, turns_into_motion_;
  double heading_, swing_, reach_;
  Vector3 mount_;         // chassis axes, relative to O
  Vector3 wheel_center_;  // fork axes, relative to the mount
  Vector3 center_;        // of fork and wheel, fork axes, relative to the mount
  // Constants of fork and wheel; the inertia is about center_, fork axes, with the wheel as not spinning.
  CasterConstants<double> constants_;
};

}  // namespace gurney
