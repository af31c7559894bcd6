#pragma once

#include <string>
#include <variant>
#include <vector>

#include "engine/base/vector.h"

/// What stands still around the item, in floor axes.
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

/// The convex hull of points, 4 or more that span a volume. Bullet rounds its edges by 0.5 mm.
struct RoomHull {
  std::vector<Vector3> points;  ///< shape axes [m]
};

/// One static shape. The item's chassis and its wheels touch it; forks have no shape.
struct RoomShape {
  std::string name;                    ///< in events; not empty, unique in a scene, not "floor"
  std::string material;                ///< against the item's: see Scene::pairs
  Vector3 position = Vector3::Zero();  ///< of the shape's centre (hull: its origin) [m]
  Quaternion rotation = Quaternion::Identity();
  std::variant<RoomBox, RoomColumn, RoomHull> shape;
};

}  // namespace gurney
