#pragma once

#include <array>
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
  /// Unit vector across the axis, fixed to a body that moves: its ends then touch at points that the
  /// body keeps. Zero: the body is at rest.
  Vector3 rim = Vector3::Zero();

  static constexpr std::size_t kRimPoints = 8;
  /// Sine of the tilt of an end: from the first on its lowest point touches, up to the second the
  /// points that the body keeps do.
  static constexpr double kTilted = 1e-3, kFlat = 0.1;

  /// Least of direction . p over all of its points.
  double lowest(const Vector3& direction) const;
  /// The part of a direction across the axis.
  Vector3 across(const Vector3& direction) const { return direction - axis.dot(direction) * axis; }
  /// Points of the rim of an end that the body keeps. @param end  -1 or 1
  std::array<Vector3, kRimPoints> rim_points(int end) const;
};

/// Appends where a convex polyhedron faces a cylinder with a gap of at most `margin`: a face along
/// a line of the side, an edge with both its ends (each with its own normal, away from the axis)
/// and where it is nearest, a corner, or what lies on an end. Points on the side or lowest on the rim
/// of a body that moves roll (FacingPoint).
///
/// Limit: the rim of an end is met by faces only; edges that cross it are found when they
/// overlap.
///
/// @param motion  displacement of a relative to b until one asks again [m]
void column_points(const ConvexShape& a, const Cylinder& b, const Vector3& motion, double margin,
                   std::vector<FacingPoint>& points);

}  // namespace gurney
