#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "engine/contact/column_points.h"
#include "engine/contact/convex_shape.h"
#include "engine/contact/facing_points.h"
#include "engine/scene/equipment_model.h"

namespace gurney {

struct Sphere {
  Vector3 center;     ///< [m]
  double radius = 0;  ///< > 0 [m]
};

/// A convex shape as the search for contacts wants it.
using BodyForm = std::variant<ConvexShape, Cylinder, Sphere>;

/// A shape of a body in axes of the item with their origin at `origin`.
BodyForm body_form(const BodyShape& shape, const Vector3& origin);

/// A form fixed to a body there, into one of its kind.
void place(const BodyForm& form, const Quaternion& rotation, const Vector3& position,
           BodyForm& result);

/// Least of direction . p over all points of a form.
double lowest(const BodyForm& form, const Vector3& direction);

/// Appends where two forms face each other with a gap of at most `margin`: convex_points of two
/// polyhedra, column_points of a polyhedron and a cylinder. A sphere meets everything in the point
/// nearest to its middle. Two cylinders meet side to side along a line or in a point; where a rim of a
/// body meets an edge or another rim, it is that of a prism of 32 sides.
///
/// @param motion  displacement of a relative to b until one asks again [m]
void form_points(const BodyForm& a, const BodyForm& b, const Vector3& motion, double margin,
                 std::vector<FacingPoint>& points);

/// The round side of a body, in chassis axes from its centre of mass.
struct RoundSurface {
  Vector3 center = Vector3::Zero();  ///< [m]
  Vector3 axis = Vector3::Zero();    ///< unit; of a sphere zero
  double radius = 0;                 ///< of polyhedra 0: they have none [m]

  /// Where a body turned by `rotation` reaches farthest along `outwards` at the place along the axis of
  /// `local`, a point of its surface in chassis axes. Floor axes.
  Vector3 farthest(const Matrix3& rotation, const Vector3& local, const Vector3& outwards) const;
};
RoundSurface round_surface(const BodyShape& shape, const Vector3& origin);

/// Volume [m3] and, for a mass, centre and inertia of a uniform solid: exact, of a hull by tetrahedra.
double volume_of(const BodyShape& shape);
MassProperties uniform_solid(double mass, const BodyShape& shape);
/// Mass properties of shapes that share the mass by their volumes; where they overlap, both count.
MassProperties uniform_solid(double mass, const std::vector<BodyShape>& shapes);

/// How high a level top of the shape is over a point of the plan; none beside it, and none where its top
/// is not level.
std::optional<double> level_top(const BodyShape& shape, const Vector2& point);

}  // namespace gurney
