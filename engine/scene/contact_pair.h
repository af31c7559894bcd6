#pragma once

#include <string>

namespace gurney {

/// Two materials in contact: a body of the item against the floor or the room
/// (docs/theory/impact.md).
struct ContactConstants {
  /// kRestitution states the rebound and no force: the stiffness then only says how long an impact
  /// takes, and an impact has no peak force. kCompliant states stiffness and damping; the rebound
  /// follows.
  enum class Kind { kRestitution, kCompliant };
  Kind kind = Kind::kRestitution;
  /// k > 0 [N/m]. With kRestitution: soft enough that rocking bodies keep their energy at the usual
  /// steps, stiff enough that no body turns much in an impact: results are within 1 % of the speed
  /// of those of a rigid contact (docs/theory/impact.md).
  double stiffness = 1e7;
  /// e of kRestitution, 0.01..1. Assumption, range 0.1 to 0.7.
  double restitution = 0.3;
  double damping = 0;     ///< c of kCompliant, >= 0 [N s/m]
  double friction = 0.4;  ///< mu >= 0. Assumption, range 0.2 to 0.8.
  /// b >= 0 of what is round: rolling friction length, moment over normal force [m].
  double rolling_resistance = 0;
};

/// Constants of a pair of materials: one of the item, one of the floor or a room shape.
struct MaterialPair {
  std::string item;
  std::string other;
  ContactConstants constants;
};

}  // namespace gurney
