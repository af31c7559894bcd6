#pragma once

#include <string>

#include "engine/base/vector.h"

namespace gurney {

/// The chassis or a wheel of an item that hit the floor, a room shape or another item (when one
/// begins and ends: engine/record/impact_log.h). Wheels that land on their treads are not among them.
struct Impact {
  double time = 0;         ///< of the first touch [s]
  std::size_t item = 0;    ///< index in Scene::items
  int wheel = -1;          ///< -1: the chassis
  std::string body;        ///< "chassis" or the caster's name
  int other_item = -1;     ///< index; -1: the floor or a room shape. Then other_item > item
  std::string other;       ///< "floor", or the name of the room shape or the other item
  std::string other_body;  ///< of another item: "chassis" or the caster's name
  Vector3 point = Vector3::Zero();   ///< floor axes [m]
  Vector3 normal = Vector3::Zero();  ///< towards the item
  double approach_speed = 0;         ///< largest of the points that came to touch [m/s]
  double impulse = 0;                ///< of the normal force on every point of the pair [N s]
  double peak_force = 0;  ///< of their sum; NaN where restitution is stated, not stiffness [N]
  double duration = 0;    ///< [s]
};

/// Outcome in a zone of the room. An item is in it when the outline of its chassis' shape on
/// the floor (the convex hull of each box, seen from above) reaches into it.
struct ZoneOutcome {
  double time_of_entry = -1;  ///< first; < 0: nothing entered [s]
  double occupied_time = 0;   ///< total [s]
  bool occupied_at_end = false;
  /// The widest strip along the whole zone that no item enters [m].
  double least_free_width = 0, free_width_at_end = 0;
};

struct TetherOutcome {
  double time_taut = -1;    ///< first; < 0: never [s]
  double time_broken = -1;  ///< < 0: it held [s]
  double peak_tension = 0;  ///< [N]
};

}  // namespace gurney
