#include "studies/playback/solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace gurney::playback {
namespace {

Vector3 middle_of(const std::vector<Vector3>& points) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

/// A shape is convex: its faces look away from its middle.
void add_triangle(std::vector<Vector3>& corners, const Vector3& middle, const Vector3& a,
                  const Vector3& b, const Vector3& c) {
  const bool outwards = (b - a).cross(c - a).dot(a - middle) >= 0;
  corners.insert(corners.end(), {a, outwards ? b : c, outwards ? c : b});
}

/// Two rings of corners, one after the other.
std::vector<Vector3> prism(const std::vector<Vector3>& points, const Vector3& middle) {
  const std::size_t n = points.size() / 2;
  std::vector<Vector3> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    add_triangle(corners, middle, points[i], points[j], points[n + j]);
    add_triangle(corners, middle, points[i], points[n + j], points[n + i]);
  }
  for (std::size_t i = 2; i < n; ++i) {
    add_triangle(corners, middle, points[0], points[i - 1], points[i]);
    add_triangle(corners, middle, points[n], points[n + i - 1], points[n + i]);
  }
  return corners;
}

/// Every triangle of three points that has all others on one side.
std::vector<Vector3> hull(const std::vector<Vector3>& points, const Vector3& middle) {
  constexpr double kFlat = 1e-9;  // [m2], [m]
  std::vector<Vector3> corners;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const Vector3 normal = (points[j] - points[i]).cross(points[k] - points[i]);
        if (normal.norm() < kFlat) continue;
        double low = 0, high = 0;
        for (const Vector3& point : points) {
          const double height = normal.normalized().dot(point - points[i]);
          low = std::min(low, height);
          high = std::max(high, height);
        }
        if (low > -kFlat || high < kFlat)
          add_triangle(corners, middle, points[i], points[j], points[k]);
      }
  return corners;
}

}  // namespace

std::vector<Vector3> triangles(const RecordedShape& shape) {
  const Vector3 middle = middle_of(shape.points);
  return shape.kind == "hull" ? hull(shape.points, middle) : prism(shape.points, middle);
}

RecordedShape shape_of(const RecordedWheel& wheel) {
  constexpr int kSides = 24;
  RecordedShape shape{wheel.name, "prism", {}};
  for (const double side : {-0.5, 0.5})
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSides;
      shape.points.emplace_back(wheel.radius * std::cos(angle), side * wheel.width,
                                wheel.radius * std::sin(angle));
    }
  return shape;
}

}  // namespace gurney::playback
