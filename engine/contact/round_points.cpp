#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/contact/body_form.h"
#include "engine/contact/convex_points.h"

// Where round bodies meet others.
namespace gurney {
namespace {

constexpr double kParallel = 1e-3;  // sine of the angle of two axes
constexpr int kPrismSides = 32;
/// A flat end that stands on points of its rim reaches lower between them, by less than this part of the
/// radius.
constexpr double kProven = 1e-3;

Vector3 on_segment(const Vector3& from, const Vector3& to, const Vector3& point) {
  const Vector3 along = to - from;
  return from + std::clamp(along.dot(point - from) / along.squaredNorm(), 0.0, 1.0) * along;
}

/// The point of a face nearest to `point`.
Vector3 nearest_on(const ConvexShape& shape, const ConvexShape::Face& face, const Vector3& point) {
  const auto corner = [&](std::size_t k) {
    return shape.corners[static_cast<std::size_t>(face.loop[k % face.loop.size()])];
  };
  const Vector3 below = point - (face.normal.dot(point) - shape.level(face)) * face.normal;
  bool inside = true;
  Vector3 nearest = below;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < face.loop.size(); ++k) {
    const Vector3 from = corner(k), to = corner(k + 1);
    if (face.normal.dot((to - from).cross(below - from)) >= 0) continue;
    inside = false;
    const Vector3 there = on_segment(from, to, point);
    if ((there - point).norm() >= distance) continue;
    distance = (there - point).norm();
    nearest = there;
  }
  return inside ? below : nearest;
}

/// A point of a surface and the way out there.
struct Surface {
  Vector3 point, normal;
};

/// The surface nearest to a point; within the body, the face that is nearest.
Surface nearest(const ConvexShape& shape, const Vector3& point) {
  double highest = -std::numeric_limits<double>::infinity();
  double distance = std::numeric_limits<double>::infinity();
  Surface best{point, Vector3::UnitZ()}, outside = best;
  for (const ConvexShape::Face& face : shape.faces) {
    const double height = face.normal.dot(point) - shape.level(face);
    if (height > highest) {
      highest = height;
      best = {point - height * face.normal, face.normal};
    }
    if (height <= 0) continue;
    const Vector3 there = nearest_on(shape, face, point);
    if ((point - there).norm() >= distance) continue;
    distance = (point - there).norm();
    outside = {there, face.normal};
  }
  if (highest <= 0) return best;
  if (distance > 0) outside.normal = (point - outside.point) / distance;
  return outside;
}

Surface nearest(const Cylinder& column, const Vector3& point) {
  const Vector3 from = point - column.center, out = column.across(from);
  const double along = column.axis.dot(from), away = out.norm();
  const Vector3 side = away > 0 ? Vector3(out / away) : column.axis.unitOrthogonal();
  const Vector3 end = std::copysign(1.0, along) * column.axis;
  const double beyond = std::abs(along) - column.half_height, beside = away - column.radius;
  if (beyond <= 0 && beside <= 0)
    return beyond > beside ? Surface{point - beyond * end, end}
                           : Surface{point - beside * side, side};
  const Vector3 there = point - std::max(beyond, 0.0) * end - std::max(beside, 0.0) * side;
  return {there, (point - there).normalized()};
}

Surface nearest(const Sphere& sphere, const Vector3& point) {
  const Vector3 from = point - sphere.center;
  const Vector3 normal = from.norm() > 0 ? Vector3(from.normalized()) : Vector3::UnitZ();
  return {sphere.center + sphere.radius * normal, normal};
}

void sphere_points(const Sphere& a, const BodyForm& b, double margin,
                   std::vector<FacingPoint>& points) {
  const Surface on_b = std::visit([&](const auto& form) { return nearest(form, a.center); }, b);
  FacingPoint point;
  point.on_a = a.center - a.radius * on_b.normal;
  point.on_b = on_b.point;
  point.normal = on_b.normal;
  point.gap = on_b.normal.dot(point.on_a - point.on_b);
  point.rolls_a = true;
  // The side of a cylinder that moves and a sphere roll; its ends do not.
  const auto* column = std::get_if<Cylinder>(&b);
  point.rolls_b = std::holds_alternative<Sphere>(b) ||
                  (column != nullptr && !column->rim.isZero() &&
                   std::abs(column->axis.dot(on_b.normal)) < Cylinder::kTilted);
  if (point.gap <= margin) points.push_back(point);
}

ConvexShape prism(const Cylinder& column) {
  ConvexShape shape;
  const Vector3 x = column.rim.isZero() ? column.axis.unitOrthogonal() : column.rim;
  const Vector3 y = column.axis.cross(x);
  ConvexShape::Face top{column.axis, {}, {}}, bottom{-column.axis, {}, {}};
  for (int i = 0; i < kPrismSides; ++i) {
    const auto out = [&](double step) -> Vector3 {
      const double angle = 2 * std::numbers::pi * step / kPrismSides;
      return std::cos(angle) * x + std::sin(angle) * y;
    };
    for (const double end : {-1.0, 1.0})
      shape.corners.push_back(column.center + column.radius * out(i) +
                              end * column.half_height * column.axis);
    const int low = 2 * i, next = 2 * ((i + 1) % kPrismSides);
    shape.faces.push_back({out(i + 0.5), {low, next, next + 1, low + 1}, {}});
    top.loop.push_back(low + 1);
    bottom.loop.push_back(2 * (kPrismSides - 1 - i));
    if (2 * i < kPrismSides) shape.edges.push_back(column.axis.cross(out(i + 0.5)));
  }
  shape.edges.push_back(column.axis);
  shape.faces.push_back(std::move(top));
  shape.faces.push_back(std::move(bottom));
  return shape;
}

void flip(std::vector<FacingPoint>& points, std::size_t first) {
  for (std::size_t i = first; i < points.size(); ++i) {
    FacingPoint& point = points[i];
    std::swap(point.on_a, point.on_b);
    std::swap(point.rolls_a, point.rolls_b);
    point.normal = -point.normal;
  }
}

/// column_points, or where its axes miss the one that separates the bodies, as an edge across a rim, those
/// of a prism in the cylinder. Points as far apart as the plane across them leaves are right: no two are
/// nearer, and no plane leaves more.
void proven_points(const ConvexShape& a, const Cylinder& b, const Vector3& motion, double margin,
                   std::vector<FacingPoint>& points) {
  const std::size_t before = points.size();
  column_points(a, b, motion, margin, points);
  if (points.size() > before) {
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(before);
    const FacingPoint& least =
        *std::ranges::min_element(first, points.end(), {}, &FacingPoint::gap);
    const double leaves = a.lowest(least.normal) + b.lowest(-least.normal);
    if (least.gap <= leaves + kProven * b.radius) return;
    points.resize(before);
  }
  convex_points(a, prism(b), motion, margin, points);
}

/// The sides of two cylinders at two points of their axes.
void add_sides(const Cylinder& a, const Cylinder& b, const Vector3& at_a, const Vector3& at_b,
               double margin, std::vector<FacingPoint>& points) {
  const Vector3 between = at_a - at_b;
  const double distance = between.norm();
  if (!(distance > 0)) return;
  const Vector3 normal = between / distance;
  const double gap = distance - a.radius - b.radius;
  if (gap > margin) return;
  points.push_back({at_a - a.radius * normal, at_b + b.radius * normal, normal, gap,
                    !a.rim.isZero(), !b.rim.isZero()});
}

void parallel_sides(const Cylinder& a, const Cylinder& b, double margin,
                    std::vector<FacingPoint>& points) {
  const Vector3 from = a.center - b.center;
  const double facing = a.axis.dot(b.axis), middle = b.axis.dot(from);
  const double half = a.half_height * std::abs(facing);
  const double low = std::max(middle - half, -b.half_height);
  const double high = std::min(middle + half, b.half_height);
  for (const double station : {low, high})
    add_sides(a, b, a.center + (station - middle) / facing * a.axis, b.center + station * b.axis,
              margin, points);
}

/// Where two axes are nearest to each other, from their middles.
struct Crossing {
  double on_a, on_b;
};
Crossing crossing(const Cylinder& a, const Cylinder& b) {
  const Vector3 from = a.center - b.center;
  const double cosine = a.axis.dot(b.axis), sine2 = 1 - cosine * cosine;
  const double along_a = a.axis.dot(from), along_b = b.axis.dot(from);
  return {(cosine * along_b - along_a) / sine2, (along_b - cosine * along_a) / sine2};
}

void cylinder_points(const Cylinder& a, const Cylinder& b, const Vector3& motion, double margin,
                     std::vector<FacingPoint>& points) {
  const double sine = a.axis.cross(b.axis).norm();
  const Vector3 from = a.center - b.center;
  const auto end_gap = [&](const Vector3& axis) {
    const Vector3 n = axis.dot(from) < 0 ? Vector3(-axis) : axis;
    return a.lowest(n) + b.lowest(-n);
  };
  const double ends_a = end_gap(a.axis), ends_b = end_gap(b.axis);
  if (sine < kParallel) {
    const double sides = b.across(from).norm() - a.radius - b.radius;
    if (sides > std::max(ends_a, ends_b)) return parallel_sides(a, b, margin, points);
  } else {
    const Crossing at = crossing(a, b);
    const Vector3 at_a = a.center + at.on_a * a.axis, at_b = b.center + at.on_b * b.axis;
    const bool within = std::abs(at.on_a) <= a.half_height && std::abs(at.on_b) <= b.half_height;
    if (within && (at_a - at_b).norm() - a.radius - b.radius > std::max(ends_a, ends_b))
      return add_sides(a, b, at_a, at_b, margin, points);
  }
  // The rim whose end is farther from the other's middle is the prism.
  if (ends_b >= ends_a) return proven_points(prism(a), b, motion, margin, points);
  const std::size_t before = points.size();
  proven_points(prism(b), a, -motion, margin, points);
  flip(points, before);
}

/// A column at rest keeps to the axes that boxes have always met it along.
void polyhedron_and_cylinder(const ConvexShape& a, const Cylinder& b, const Vector3& motion,
                             double margin, std::vector<FacingPoint>& points) {
  if (b.rim.isZero()) return column_points(a, b, motion, margin, points);
  proven_points(a, b, motion, margin, points);
}

}  // namespace

void form_points(const BodyForm& a, const BodyForm& b, const Vector3& motion, double margin,
                 std::vector<FacingPoint>& points) {
  const std::size_t before = points.size();
  if (const auto* sphere = std::get_if<Sphere>(&a))
    return sphere_points(*sphere, b, margin, points);
  if (const auto* sphere = std::get_if<Sphere>(&b)) {
    sphere_points(*sphere, a, margin, points);
    return flip(points, before);
  }
  const auto *solid_a = std::get_if<ConvexShape>(&a), *solid_b = std::get_if<ConvexShape>(&b);
  if (solid_a && solid_b) return convex_points(*solid_a, *solid_b, motion, margin, points);
  if (solid_a)
    return polyhedron_and_cylinder(*solid_a, std::get<Cylinder>(b), motion, margin, points);
  if (solid_b) {
    polyhedron_and_cylinder(*solid_b, std::get<Cylinder>(a), -motion, margin, points);
    return flip(points, before);
  }
  cylinder_points(std::get<Cylinder>(a), std::get<Cylinder>(b), motion, margin, points);
}

}  // namespace gurney
