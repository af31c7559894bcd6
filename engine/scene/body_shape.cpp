#include "engine/scene/body_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/linear_algebra.h"

namespace gurney {
namespace {

constexpr int kSides = 32;  // of a cylinder

/// A ring of points round a centre, across an axis.
void add_ring(const Vector3& center, const Vector3& axis, double radius,
              std::vector<Vector3>& points) {
  const Vector3 x = axis.unitOrthogonal(), y = axis.cross(x);
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    points.push_back(center + radius * (std::cos(angle) * x + std::sin(angle) * y));
  }
}

/// The corners of an icosahedron and the middles of its edges, on the unit sphere.
std::vector<Vector3> directions_round() {
  std::vector<Vector3> corners;
  for (const double one : {-1.0, 1.0})
    for (const double other : {-std::numbers::phi, std::numbers::phi}) {
      corners.emplace_back(0, one, other);
      corners.emplace_back(one, other, 0);
      corners.emplace_back(other, 0, one);
    }
  std::vector<Vector3> directions;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    directions.push_back(corners[i].normalized());
    for (std::size_t j = 0; j < i; ++j)
      if ((corners[i] - corners[j]).norm() < 2.1)  // an edge is 2 long
        directions.push_back((corners[i] + corners[j]).normalized());
  }
  return directions;
}

}  // namespace

BodyShape cylinder_shape(const Vector3& center, const SolidCylinder& cylinder) {
  // A disc across the unit axis a reaches r sqrt(1 - a_x^2) along x.
  const Vector3 across =
      (Vector3::Ones() - cylinder.axis.cwiseAbs2()).cwiseMax(0).cwiseSqrt() * cylinder.radius;
  return {center, 2 * across + cylinder.length * cylinder.axis.cwiseAbs(), cylinder};
}

BodyShape sphere_shape(const Vector3& center, double radius) {
  return {center, Vector3::Constant(2 * radius), SolidSphere{radius}};
}

BodyShape hull_shape(const std::vector<Vector3>& points) {
  Vector3 low = points.front(), high = low;
  for (const Vector3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Vector3 center = 0.5 * (low + high);
  SolidHull hull;
  for (const Vector3& point : points) hull.corners.push_back(point - center);
  return {center, high - low, hull};
}

double reach_from(const BodyShape& shape, const Vector3& point) {
  const double away = (shape.center - point).norm();
  if (const auto* cylinder = std::get_if<SolidCylinder>(&shape.solid))
    return away + std::hypot(cylinder->radius, 0.5 * cylinder->length);
  if (const auto* sphere = std::get_if<SolidSphere>(&shape.solid)) return away + sphere->radius;
  const auto* hull = std::get_if<SolidHull>(&shape.solid);
  if (hull == nullptr) return away + 0.5 * shape.size.norm();
  double reach = 0;
  for (const Vector3& corner : hull->corners)
    reach = std::max(reach, (shape.center + corner - point).norm());
  return reach;
}

std::vector<Vector3> outline_points(const BodyShape& shape) {
  std::vector<Vector3> points;
  if (const auto* cylinder = std::get_if<SolidCylinder>(&shape.solid)) {
    for (const double end : {-0.5, 0.5})
      add_ring(shape.center + end * cylinder->length * cylinder->axis, cylinder->axis,
               cylinder->radius, points);
  } else if (const auto* sphere = std::get_if<SolidSphere>(&shape.solid)) {
    for (const Vector3& direction : directions_round())
      points.push_back(shape.center + sphere->radius * direction);
  } else if (const auto* hull = std::get_if<SolidHull>(&shape.solid)) {
    for (const Vector3& corner : hull->corners) points.push_back(shape.center + corner);
  } else {
    for (int k = 0; k < 8; ++k) {
      const Vector3 side(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
      points.push_back(shape.center + 0.5 * side.cwiseProduct(shape.size));
    }
  }
  return points;
}

bool spans_a_volume(const std::vector<Vector3>& points) {
  if (points.size() < 4) return false;
  Eigen::Matrix3Xd spread(3, points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    spread.col(static_cast<Eigen::Index>(i)) = points[i] - points[0];
  return spread.allFinite() && rank(spread) == 3;
}

}  // namespace gurney
