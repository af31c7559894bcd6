#pragma once

#include <vector>

#include "engine/contact/convex_shape.h"
#include "engine/contact/facing_points.h"

namespace gurney {

/// A cylinder.
struct Cylinder {
  Vector3 center;          ///< [m]
  Vector3 axis;            ///< unit
  double radius = 0;       ///< > 0 [m]
  double half_height = 0;  ///< > 0 [m]
};

/// Appends where a convex polyhedron faces a cylinder with a gap of at most `margin`: a face along
/// a line of the side, an edge with both its ends (each with its own normal, away from the axis)
/// and where it is nearest, a corner, or what lies on an end.
///
/// Limit: the rim of an end is met by faces only; edges that cross it are found when they
/// overlap.
///
/// @param motion  displacement of a relative to b until one asks again [m]
void column_points(const ConvexShape& a, const Cylinder& b, const Vector3& motion, double margin,
                   std::vector<FacingPoint>& points);

}  // namespace gurney
