#pragma once

#include <vector>

#include "engine/contact/convex_shape.h"

namespace gurney {

/// Two points of two bodies that face each other.
struct ConvexPoint {
  Vector3 on_a, on_b;  ///< on the surfaces [m]
  Vector3 normal;      ///< unit, towards a
  double gap;          ///< normal . (on_a - on_b): the bodies overlap where it is negative [m]
};

/// Appends where two convex polyhedra face each other with a gap of at most `margin`.
///
/// The normal is the axis that separates them most, or overlaps least: of all face normals and all
/// cross products of two edges one is it (Gottschalk, Lin & Manocha 1996 for boxes). The two faces
/// that look at each other along it are projected on the plane across, and the corners of the
/// polygon they have in common are the points: four corners of a block before a wall, one where two
/// edges cross or a corner meets a face. They are the same whether the bodies overlap or not.
///
/// Where several axes separate them - two bodies that pass each other at a corner - `motion`
/// decides: they meet along the axis on which they come to overlap last, and the faces are compared
/// as they are then.
///
/// @param motion  displacement of a relative to b until one asks again [m]
void convex_points(const ConvexShape& a, const ConvexShape& b, const Vector3& motion, double margin,
                   std::vector<ConvexPoint>& points);

}  // namespace gurney
