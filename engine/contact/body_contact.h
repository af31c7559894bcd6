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
    int caster = -1;       ///< -1: on the chassis; else on the wheel of this caster
    /// Chassis: chassis axes, relative to its centre; wheel: fork axes, relative to the mount (the
    /// point does not turn with the axle).
    Vector3 local = Vector3::Zero();
    /// Direction of a tread or a round chassis before a plane: against the plane's normal, unit, floor
    /// axes. The point is where the tread, or the side of the chassis' shape `round`, is farthest this
    /// way, however the body turns, and `local` where that was when the contact was found. Zero: the
    /// point is `local`.
    Vector3 outwards = Vector3::Zero();
    int round = -1;  ///< of the chassis: index in EquipmentModel::shape

    bool same_body(const Side& b) const { return item == b.item && caster == b.caster; }
    /// Whether both are the same point at two times. 1e-6 m of a point and 1e-9 of a normal are the
    /// rounding of their construction; a round body rolls, but its lowest point does not jump.
    bool same_point(const Side& b) const {
      constexpr double kJump = 0.02;  // [m]
      const double moved = (local - b.local).norm();
      if (outwards.isZero()) return moved < 1e-6;
      return (outwards - b.outwards).norm() < 1e-9 && round == b.round &&
             (round < 0 || moved < kJump);
    }
  };
  static constexpr int kItem = -1;

  Side side;
  int other = 0;  ///< 0: the floor; i + 1: room shape i; kItem: `other_side`, of a later item
  Side other_side;
  Vector3 normal = Vector3::UnitZ();  ///< unit, towards `side`, floor axes
  double offset = 0;  ///< of floor and room shapes: gap = normal . point - offset; of
                      ///< two items: gap = normal . (point - other point) - offset [m]

  bool between_items() const { return other == kItem; }
  /// Whether both are the same point before the same plane at two times.
  bool same_place(const BodyContact& b) const {
    return side.same_point(b.side) && (normal - b.normal).norm() < 1e-9 &&
           other_side.same_point(b.other_side);
  }
  /// Whether both may be the same contact at two times: points of one pair of bodies.
  bool same_pair(const BodyContact& b) const {
    return side.same_body(b.side) && other == b.other &&
           (other != kItem || other_side.same_body(b.other_side));
  }
};

/// State of such a contact.
struct BodyContactState {
  BodyContact contact;
  Vector3 deflection = Vector3::Zero();  ///< tangential, floor axes [m]
  Vector3 lead = Vector3::Zero();        ///< of the pressure below what rolls, floor axes [m]
  double compression = 0;                ///< overlap [m]
  bool sliding = false;                  ///< its friction is at the limit
  double approach_speed = 0;             ///< when it last touched, or now while apart [m/s]
  /// How much deeper the bodies overlap than `compression`: see Stepper::set_contacts [m].
  double slack = 0;
  bool kept_place = false;  ///< the last pass found it where it was
};

}  // namespace gurney
