#pragma once

#include <vector>

#include "engine/base/vector.h"
#include "engine/contact/facing_points.h"

namespace gurney {

/// A convex polyhedron, as the search for contacts wants it.
struct ConvexShape {
  struct Face {
    Vector3 normal;            ///< unit, outwards
    std::vector<int> loop;     ///< its corners, counterclockwise seen from outside
    std::vector<int> members;  ///< every point in its plane, in order
  };
  std::vector<Vector3> corners;  ///< [m]
  std::vector<Face> faces;
  std::vector<Vector3> edges;  ///< unit directions, parallel ones once

  /// Least of direction . p over all of its points.
  double lowest(const Vector3& direction) const;
  /// normal . p of the points of a face [m].
  double level(const Face& face) const;
  /// The face that holds most of the corners farthest along `direction`; of equal ones the one that
  /// looks there most.
  SurfacePiece facing(const Vector3& direction) const;
  /// The same, fixed to a body there.
  ConvexShape placed(const Quaternion& rotation, const Vector3& position) const;
  /// Places into a shape that was placed before.
  void place(const Quaternion& rotation, const Vector3& position, ConvexShape& result) const;
};

/// @param size  full edge lengths, > 0 [m]
ConvexShape convex_box(const Vector3& center, const Vector3& size);

/// The convex hull of points that span a volume: a plane through three of them with all others on
/// one side is a face, and so are points that miss that plane by less than 0.5 mm. Its cost grows
/// with the cube of their number, at least.
ConvexShape convex_hull(const std::vector<Vector3>& points);

/// The hull of a body whose points come from a drawing: those that miss a plane by less than 1e-4 of the
/// size are in it.
ConvexShape convex_body(const std::vector<Vector3>& points);

/// Points that are corners of a face, in their order.
std::vector<Vector3> corners_of(const ConvexShape& shape);

}  // namespace gurney
