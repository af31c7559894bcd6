#pragma once

#include <variant>
#include <vector>

#include "engine/base/vector.h"

/// Convex shapes fixed to a body, in item axes, SI units.
namespace gurney {

/// The box that surrounds the shape, itself.
struct SolidBox {};

struct SolidCylinder {
  Vector3 axis = Vector3::UnitZ();  ///< unit
  double radius = 0;                ///< > 0 [m]
  double length = 0;                ///< > 0 [m]
};

struct SolidSphere {
  double radius = 0;  ///< > 0 [m]
};

/// The convex hull of points that span a volume.
struct SolidHull {
  static constexpr std::size_t kMaxCorners = 64;
  std::vector<Vector3> corners;  ///< 4 to kMaxCorners, from the shape's centre [m]
};

/// One convex shape: a solid within the smallest box along the item's axes that surrounds it.
struct BodyShape {
  Vector3 center = Vector3::Zero();  ///< of that box; the middle of cylinders and spheres [m]
  Vector3 size = Vector3::Zero();    ///< full edge lengths of that box, > 0 [m]
  std::variant<SolidBox, SolidCylinder, SolidSphere, SolidHull> solid = {};

  bool is_box() const { return std::holds_alternative<SolidBox>(solid); }
  double bottom() const { return center.z() - size.z() / 2; }  ///< [m]
  double top() const { return center.z() + size.z() / 2; }     ///< [m]
  BodyShape moved(const Vector3& by) const { return {by + center, size, solid}; }
};

BodyShape cylinder_shape(const Vector3& center, const SolidCylinder& cylinder);
BodyShape sphere_shape(const Vector3& center, double radius);
BodyShape hull_shape(const std::vector<Vector3>& points);  ///< @param points  1 or more [m]

/// Largest distance of any of its points from `point` [m].
double reach_from(const BodyShape& shape, const Vector3& point);

/// Points whose convex hull the shape is, to draw it and to look at it from above. A box has 8; of a
/// cylinder they are those of a prism of 32 sides in it, one ring after the other, of a sphere 42 that lie
/// on it.
std::vector<Vector3> outline_points(const BodyShape& shape);

/// Whether points span a volume.
bool spans_a_volume(const std::vector<Vector3>& points);

}  // namespace gurney
