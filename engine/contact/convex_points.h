#pragma once

#include <vector>

#include "engine/contact/convex_shape.h"
#include "engine/contact/facing_points.h"

namespace gurney {

/// Appends where two convex polyhedra face each other with a gap of at most `margin`.
///
/// The normal is an axis that separates them: of all face normals and all cross products of two
/// edges one is it (Gottschalk, Lin & Manocha 1996 for boxes). The two faces that look at each
/// other along it have a polygon in common, whose corners are the points: four corners of a block
/// before a wall, one where two edges cross or a corner meets a face. They are the same whether the
/// bodies overlap or not.
///
/// @param motion  displacement of a relative to b until one asks again [m]
void convex_points(const ConvexShape& a, const ConvexShape& b, const Vector3& motion, double margin,
                   std::vector<FacingPoint>& points);

}  // namespace gurney
