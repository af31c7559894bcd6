#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/base/vector.h"
#include "engine/caster/caster_dynamics.h"
#include "engine/contact/body_contact.h"
#include "engine/scene/equipment_model.h"
#include "engine/solver/loads_state.h"

namespace gurney {

inline constexpr std::size_t kMaxCasters = EquipmentModel::kMaxCasters;

/// Generalised velocity: of the chassis (its centre of mass, floor axes) and of every caster's
/// joints.
struct Velocity {
  Vector6 chassis = Vector6::Zero();
  std::array<Eigen::Vector2d, kMaxCasters> joints;

  Velocity() { joints.fill(Eigen::Vector2d::Zero()); }
};

/// State of one caster.
struct CasterState {
  double swivel_angle = 0;  ///< of the fork from the item's x axis [rad]
  double axle_angle = 0;    ///< [rad]
  TreadState tread;
  double swivel_wind = 0;  ///< deflection of stuck swivel friction [rad]
  double axle_wind = 0;    ///< of stuck axle friction or brake [rad]
  bool axle_slips = false;
};

/// Everything of one item that evolves.
struct State {
  double time = 0;
  Vector3 position = Vector3::Zero();  ///< of the chassis' centre of mass, floor axes
  Quaternion rotation = Quaternion::Identity();
  Velocity velocity;
  std::array<CasterState, kMaxCasters> casters;
  LoadsState loads;
  std::uint32_t broken_tethers = 0;  ///< bit i: the i-th of Tethers

  Pose pose() const { return {position, rotation.toRotationMatrix()}; }
};

/// State of one joint between items.
struct JointState {
  double coordinate = 0;  ///< q, not wrapped [m], [rad]
  double wind = 0;        ///< deflection of stuck friction [m], [rad]
  bool latched = false;
  double latched_at = 0;             ///< q where the latch caught
  std::array<double, 2> approach{};  ///< speed at which it last met its lower and upper stop
};

/// Everything of a scene that evolves.
struct SceneState {
  std::vector<State> items;        ///< as Scene::items
  std::vector<JointState> joints;  ///< as Assembly::joints
  std::vector<BodyContactState> contacts;
};

/// Rotation by the vector `angle` (axis times angle), after `rotation`.
inline Quaternion rotated(const Vector3& angle, const Quaternion& rotation) {
  const double half = 0.5 * angle.norm();
  const double sine = std::sin(half), cosine = std::cos(half);  // one call for both
  const double sinc = half > 1e-8 ? sine / half : 1 - half * half / 6;
  const double s = 0.5 * sinc;
  const double x = s * angle.x(), y = s * angle.y(), z = s * angle.z(), w = cosine;
  // Eigen's product, number by number: written by twos and read by four it would be waited for.
  const double b = rotation.x(), c = rotation.y(), d = rotation.z(), a = rotation.w();
  const double qx = (w * b + y * d) - (z * c - x * a), qy = (w * c + y * a) + (z * b - x * d);
  const double qz = (w * d - y * b) + (z * a + x * c), qw = (w * a - y * c) - (z * d + x * b);
  const double length = std::sqrt((qx * qx + qz * qz) + (qy * qy + qw * qw));
  return {qw / length, qx / length, qy / length, qz / length};
}

}  // namespace gurney
