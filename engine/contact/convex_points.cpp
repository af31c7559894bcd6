#include "engine/contact/convex_points.h"

#include "engine/contact/axis_choice.h"

namespace gurney {
namespace {

constexpr double kParallel = 1e-6;  // sine of the angle of two edges

bool choose_axis(const ConvexShape& a, const ConvexShape& b, AxisChoice& choice) {
  for (const ConvexShape::Face& face : b.faces) {
    const double gap = a.lowest(face.normal) - b.level(face);
    if (!choice.consider(face.normal, gap, 0)) return false;
  }
  for (const ConvexShape::Face& face : a.faces) {
    const double gap = b.lowest(face.normal) - a.level(face);
    if (!choice.consider(-face.normal, gap, AxisChoice::kHandicap)) return false;
  }
  for (const Vector3& edge_a : a.edges)
    for (const Vector3& edge_b : b.edges) {
      const Vector3 across = edge_a.cross(edge_b);
      const double size = across.norm();
      if (size < kParallel) continue;
      for (const Vector3& normal : {Vector3(across / size), Vector3(-across / size)}) {
        const double gap = a.lowest(normal) + b.lowest(-normal);
        if (!choice.consider(normal, gap, AxisChoice::kHandicap)) return false;
      }
    }
  return true;
}

}  // namespace

void convex_points(const ConvexShape& a, const ConvexShape& b, const Vector3& motion, double margin,
                   std::vector<FacingPoint>& points) {
  AxisChoice choice(motion, margin);
  if (!choose_axis(a, b, choice)) return;
  const Vector3& normal = choice.normal();
  facing_points(a.facing(-normal), b.facing(normal), normal, choice.shift(), margin, points);
}

}  // namespace gurney
