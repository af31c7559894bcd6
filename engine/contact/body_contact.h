#pragma once

#include <cstddef>

#include "engine/base/vector.h"

namespace gurney {

/// A contact of an item with something else than wheel on floor: a point fixed to one of its bodies
/// against a plane of the floor or a room shape, or against a point of another item.
struct BodyContact {
  /// A point of an item.
  struct Side {
    std::size_t item = 0;  ///< index in Scene::items
    int leg = -1;          ///< -1: on the chassis; else on the wheel of this leg
    /// Chassis: chassis axes, relative to its centre; wheel: fork axes, relative to the mount (the
    /// point does not turn with the axle).
    Vector3 local = Vector3::Zero();

    bool same_body(const Side& b) const { return item == b.item && leg == b.leg; }
  };
  static constexpr int kItem = -1;

  Side side;
  int other = 0;  ///< 0: the floor; i + 1: room shape i; kItem: `other_side`, of a later item
  Side other_side;
  Vector3 normal = Vector3::UnitZ();  ///< unit, towards `side`, floor axes
  double offset = 0;                  ///< of floor and room shapes: gap = normal . point - offset;
                                      ///< of two items: gap = normal . (point - other point) [m]

  bool between_items() const { return other == kItem; }
  /// Whether both may be the same contact at two times: points of one pair of bodies.
  bool same_pair(const BodyContact& b) const {
    return side.same_body(b.side) && other == b.other &&
           (other != kItem || other_side.same_body(b.other_side));
  }
};

/// What such a contact remembers.
struct BodyContactState {
  BodyContact contact;
  Vector3 deflection = Vector3::Zero();  ///< tangential, floor axes [m]
  double compression = 0;                ///< overlap [m]
  bool sliding = false;                  ///< its friction is at the limit
  double approach_speed = 0;             ///< when it last touched, or now while apart [m/s]
};

}  // namespace gurney
