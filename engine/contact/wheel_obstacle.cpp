#include "engine/contact/wheel_obstacle.h"

#include <algorithm>
#include <cmath>

namespace gurney {
namespace {

/// Normals that may be the true one of a guess: cosine of the angle.
constexpr double kNear = 0.866;
constexpr double kSameFace = 1 - 1e-9;  // cosine of the angle
constexpr int kBisections = 40;         // of at most 180 degrees: to 3e-12 rad

}  // namespace

WheelObstacle::WheelObstacle(const ConvexShape& shape) : shape_(shape) {
  for (std::size_t f = 0; f < shape.faces.size(); ++f)
    for (std::size_t g = f + 1; g < shape.faces.size(); ++g) {
      const std::vector<int>&a = shape.faces[f].loop, &b = shape.faces[g].loop;
      for (std::size_t k = 0; k < a.size(); ++k) {
        const int first = a[k], second = a[(k + 1) % a.size()];
        if (std::ranges::count(b, first) == 0 || std::ranges::count(b, second) == 0) continue;
        edges_.push_back({shape.corners[static_cast<std::size_t>(first)], shape.faces[f].normal,
                          shape.faces[g].normal});
      }
    }
}

WheelObstacle::Plane WheelObstacle::between(const Vector3& guess, const Lowest& lowest) const {
  Plane best{guess, -shape_.lowest(-guess)};
  double widest = guess.dot(lowest(guess)) - best.offset;
  const auto consider = [&](const Plane& plane) {
    if (!(plane.normal.dot(guess) > kNear)) return;
    const double gap = plane.normal.dot(lowest(plane.normal)) - plane.offset;
    if (!(gap > widest)) return;
    widest = gap;
    best = plane;
  };
  for (const ConvexShape::Face& face : shape_.faces) consider({face.normal, shape_.level(face)});
  for (const Edge& edge : edges_) {
    // From one face's normal to the other the gap (w - p) . n grows while (w - p) . n' > 0, w being
    // the wheel's lowest point.
    const Vector3 across = edge.from.cross(edge.to).normalized();
    const auto grows = [&](const Vector3& normal) {
      return (lowest(normal) - edge.point).dot(across.cross(normal)) > 0;
    };
    Vector3 low = edge.from, high = edge.to;
    if (!grows(low) || grows(high)) continue;
    for (int i = 0; i < kBisections; ++i) {
      const Vector3 middle = (low + high).normalized();
      (grows(middle) ? low : high) = middle;
    }
    const Vector3 normal = (low + high).normalized();
    consider({normal, normal.dot(edge.point)});
  }
  return best;
}

bool WheelObstacle::faces(const Vector3& normal, const Vector3& point) const {
  bool found = false;
  for (const ConvexShape::Face& face : shape_.faces) {
    const bool own = face.normal.dot(normal) > kSameFace;
    found |= own;
    if (!own && face.normal.dot(point) > shape_.level(face)) return false;
  }
  return found;
}

}  // namespace gurney
