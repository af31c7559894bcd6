#pragma once

#include "engine/base/vector.h"

namespace gurney {

/// A contact of the item with something else than wheel on floor: a point fixed to a body of the
/// item against a plane of the floor or a room shape.
///
/// Two items in one scene will need a second point and body here instead of `offset`, and couple
/// their 6 x 6 systems through the difference of the two Jacobians.
struct BodyContact {
  enum class Body { kChassis, kWheel };
  Body body = Body::kChassis;
  int leg = -1;   ///< of kWheel
  int other = 0;  ///< 0: the floor; i + 1: room shape i
  /// kChassis: chassis axes, relative to its centre; kWheel: fork axes, relative to the mount (the
  /// point does not turn with the axle).
  Vector3 local = Vector3::Zero();
  Vector3 normal = Vector3::UnitZ();  ///< unit, towards the item, floor axes
  double offset = 0;                  ///< gap = normal . point - offset [m]

  /// Whether both may be the same contact at two times: points of one pair of bodies.
  bool same_pair(const BodyContact& b) const {
    return body == b.body && leg == b.leg && other == b.other;
  }
};

/// What such a contact remembers.
struct BodyContactState {
  BodyContact contact;
  Vector3 deflection = Vector3::Zero();  ///< tangential, floor axes [m]
  double compression = 0;                ///< overlap [m]
  double approach_speed = 0;             ///< when it last touched, or now while apart [m/s]
};

}  // namespace gurney
