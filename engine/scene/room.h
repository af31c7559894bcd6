#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/vector.h"

/// Walls and obstacles at rest around the items, in floor axes.
namespace gurney {

/// A box: wall, kerb, threshold, fixed furniture.
struct RoomBox {
  Vector3 size = Vector3::Zero();  ///< full edge lengths, > 0 [m]
};

/// A cylinder whose axis is the shape's z axis.
struct RoomColumn {
  double radius = 0;  ///< > 0 [m]
  double height = 0;  ///< > 0 [m]
};

/// The convex hull of points, 4 or more that span a volume. Its edges are sharp, for bodies and
/// wheels.
struct RoomHull {
  std::vector<Vector3> points;  ///< shape axes [m]
};

/// One static shape. Chassis and wheels touch it; forks have no shape.
struct RoomShape {
  std::string name;                    ///< in events; not empty, unique in a scene, not "floor"
  std::string material;                ///< against the item's: see Scene::pairs
  Vector3 position = Vector3::Zero();  ///< of the shape's centre (hull: its origin) [m]
  Quaternion rotation = Quaternion::Identity();
  std::variant<RoomBox, RoomColumn, RoomHull> shape;
};

/// A rectangle of the floor that should stay free: a doorway, an egress lane, the place beside a
/// bed. Its x axis is the way through.
struct Zone {
  std::string name;                  ///< unique among zones, not empty
  Vector2 center = Vector2::Zero();  ///< [m]
  double length = 0;                 ///< along its x axis, > 0 [m]
  double width = 0;                  ///< across, > 0 [m]
  double angle = 0;                  ///< of its x axis from the floor's [rad]
};

/// A cord, hose or line from an item, a part or a content to a point of the room or of another of them. It pulls
/// when it is longer than its slack length, and breaks (or unplugs) at its strength.
struct Tether {
  std::string name;                  ///< unique among tethers, not empty
  std::size_t item = 0;              ///< index in Scene::items
  Vector3 point = Vector3::Zero();   ///< on the chassis, item axes [m]
  Vector3 anchor = Vector3::Zero();  ///< floor axes, or item axes of `anchor_item` [m]
  double slack_length = 0;           ///< > 0, not less than the distance at the start [m]
  double stiffness = 0;              ///< > 0 [N/m]
  double damping = 0;                ///< while taut, >= 0 [N s/m]
  double strength = std::numeric_limits<double>::infinity();  ///< > 0 [N]
  double slack_pull = 0;  ///< horizontally towards the anchor, whether taut or not, >= 0 [N]
  std::optional<std::size_t> anchor_item = {};  ///< where it ends; empty: in the room
};

}  // namespace gurney
