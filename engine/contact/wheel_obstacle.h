#pragma once

#include <functional>
#include <vector>

#include "engine/contact/convex_shape.h"

namespace gurney {

/// A convex polyhedron that wheels meet: a kerb, a threshold, a wall.
///
/// Two convex bodies are apart by the largest distance that any plane between them leaves. A search
/// on smooth bodies finds its normal to some 0.01 rad only, which is 1 % of a wheel's load as a
/// force along the floor; here it is found exactly from there, on faces and edges.
class WheelObstacle {
 public:
  explicit WheelObstacle(const ConvexShape& shape);

  struct Plane {
    Vector3 normal;  ///< unit, towards the wheel
    double offset;   ///< normal . p of the polyhedron's points is at most this [m]
  };
  /// The point of the wheel that is lowest along a normal, in the same axes as the polyhedron.
  using Lowest = std::function<Vector3(const Vector3& normal)>;

  /// Normal that leaves most, among `guess`, the normals of the faces and those between two faces at
  /// their edge, each less than 30 degrees from `guess`. At a corner it is `guess`.
  Plane between(const Vector3& guess, const Lowest& lowest) const;

  /// Whether a point near the face with this normal is before or behind that face, and not beside
  /// it; of normals that no face has, never.
  bool faces(const Vector3& normal, const Vector3& point) const;

 private:
  struct Edge {
    Vector3 point;
    Vector3 from, to;  ///< normals of its faces
  };

  ConvexShape shape_;
  std::vector<Edge> edges_;
};

}  // namespace gurney
