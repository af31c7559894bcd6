#include "engine/bullet/hull_corners.h"

#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <tuple>

#include "engine/bullet/convert.h"

namespace gurney {
namespace {

bool before(const Vector3& a, const Vector3& b) {
  return std::make_tuple(a.x(), a.y(), a.z()) < std::make_tuple(b.x(), b.y(), b.z());
}

}  // namespace

std::vector<Vector3> hull_corners(std::vector<Vector3> points) {
  std::ranges::sort(points, before);
  const auto repeated = std::ranges::unique(points);
  points.erase(repeated.begin(), repeated.end());
  std::vector<btVector3> given;
  for (const Vector3& point : points) given.push_back(to_bullet(point));
  btConvexHullComputer hull;
  if (!given.empty())
    hull.compute(&given.front().x(), sizeof(btVector3), static_cast<int>(given.size()), 0, 0);
  // Its corners are rounded to its grid: the points they stand for are the nearest.
  std::vector<Vector3> corners;
  for (int i = 0; i < hull.vertices.size(); ++i) {
    const Vector3 rounded = from_bullet(hull.vertices[i]);
    corners.push_back(*std::ranges::min_element(
        points, {}, [&](const Vector3& point) { return (point - rounded).squaredNorm(); }));
  }
  std::ranges::sort(corners, before);
  const auto twice = std::ranges::unique(corners);
  corners.erase(twice.begin(), twice.end());
  return corners;
}

}  // namespace gurney
