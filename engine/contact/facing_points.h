#pragma once

#include <vector>

#include "engine/base/vector.h"

namespace gurney {

/// Two points of two bodies that face each other.
struct FacingPoint {
  Vector3 on_a, on_b;  ///< on the surfaces [m]
  Vector3 normal;      ///< unit, towards a
  double gap;          ///< normal . (on_a - on_b): the bodies overlap where it is negative [m]
  /// Whether the point is where a round body reaches farthest, however it turns.
  bool rolls_a = false, rolls_b = false;
};

/// A plane piece of a surface: a convex polygon, counterclockwise seen from outside, or a segment.
struct SurfacePiece {
  std::vector<Vector3> outline;
  Vector3 normal;  ///< unit, outwards; of a segment: across it
};

/// Projects a piece of a, displaced by `shift`, and one of b along `normal`, and appends the
/// corners of what they have in common: with a's displacement taken back, and if the gap is then at
/// most `margin`. Of two segments nothing is found.
void facing_points(const SurfacePiece& a, const SurfacePiece& b, const Vector3& normal,
                   const Vector3& shift, double margin, std::vector<FacingPoint>& points);

}  // namespace gurney
