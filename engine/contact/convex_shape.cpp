#include "engine/contact/convex_shape.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/error.h"

namespace gurney {
namespace {

/// Points of a hull nearer to a plane than this belong to one face: coordinates in files are
/// rounded to millimetres [m].
constexpr double kFlat = 5e-4;
/// ... but not more than this part of its size.
constexpr double kFlatPart = 1e-3;
constexpr double kFlatOfBody = 1e-4;  // part of its size
constexpr double kExact = 1e-9;       // part of a box's size
constexpr double kParallel = 1e-9;    // sine of the angle
/// Corners this near to the outermost one touch with it [m].
constexpr double kSameLevel = 1e-6;
/// A face that turns its edge faces nothing: cosine of the angle.
constexpr double kEdgeOn = 1e-6;

double spread_of(const std::vector<Vector3>& points) {
  double spread = 0;
  for (const Vector3& p : points) spread = std::max(spread, (p - points.front()).norm());
  return spread;
}

/// The corners of the polygon that `members`, all on one plane, span: counterclockwise about
/// `normal` (Andrew's monotone chain).
std::vector<int> outline(const std::vector<Vector3>& points, std::vector<int> members,
                         const Vector3& normal, double flat) {
  const Vector3 x = normal.unitOrthogonal(), y = normal.cross(x);
  const auto flattened = [&](int i) {
    const Vector3& p = points[static_cast<std::size_t>(i)];
    return Vector2(x.dot(p), y.dot(p));
  };
  std::sort(members.begin(), members.end(), [&](int i, int j) {
    const Vector2 a = flattened(i), b = flattened(j);
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<int> loop;
  if (members.size() < 3) return loop;
  const auto chain = [&](auto first, auto last) {
    const std::size_t start = loop.size();
    for (auto it = first; it != last; ++it) {
      while (loop.size() >= start + 2) {
        const Vector2 a = flattened(loop[loop.size() - 2]);
        const Vector2 u = flattened(loop.back()) - a, v = flattened(*it) - a;
        if (u.x() * v.y() - u.y() * v.x() > flat * v.norm()) break;
        loop.pop_back();
      }
      loop.push_back(*it);
    }
    loop.pop_back();  // the first of the other chain
  };
  chain(members.begin(), members.end());
  chain(members.rbegin(), members.rend());
  return loop;
}

void add_edges(ConvexShape& shape) {
  for (const ConvexShape::Face& face : shape.faces)
    for (std::size_t k = 0; k < face.loop.size(); ++k) {
      const auto a = static_cast<std::size_t>(face.loop[k]);
      const auto b = static_cast<std::size_t>(face.loop[(k + 1) % face.loop.size()]);
      const Vector3 edge = (shape.corners[b] - shape.corners[a]).normalized();
      const bool known = std::any_of(shape.edges.begin(), shape.edges.end(), [&](const Vector3& e) {
        return e.cross(edge).norm() < kParallel;
      });
      if (!known) shape.edges.push_back(edge);
    }
}

/// Adds the face through three corners if all others are below it or on it.
void add_face(ConvexShape& shape, const std::array<int, 3>& triple, const Vector3& normal,
              double flat) {
  const auto height = [&](int i) {
    return normal.dot(shape.corners[static_cast<std::size_t>(i)] -
                      shape.corners[static_cast<std::size_t>(triple[0])]);
  };
  std::vector<int> members;
  for (int i = 0; i < static_cast<int>(shape.corners.size()); ++i) {
    if (height(i) > flat) return;
    if (height(i) > -flat) members.push_back(i);
  }
  if (members.size() < 3) return;  // corners that are no numbers
  std::vector<int> loop = outline(shape.corners, members, normal, flat);
  if (loop.size() >= 3) shape.faces.push_back({normal, std::move(loop), std::move(members)});
}

ConvexShape hull_of(const std::vector<Vector3>& points, double flat) {
  ConvexShape shape;
  shape.corners = points;
  const auto n = static_cast<int>(points.size());
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  const auto known = [&](const std::array<int, 3>& triple, const Vector3& normal) {
    const auto holds = [&](const ConvexShape::Face& face) {
      return face.normal.dot(normal) > 0 && std::all_of(triple.begin(), triple.end(), [&](int i) {
               return std::binary_search(face.members.begin(), face.members.end(), i);
             });
    };
    return std::any_of(shape.faces.begin(), shape.faces.end(), holds);
  };
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k) {
        const Vector3 across = (at(j) - at(i)).cross(at(k) - at(i));
        if (!(across.norm() > flat * (at(j) - at(i)).norm())) continue;
        const std::array<int, 3> triple{i, j, k};
        for (const Vector3& normal : {across.normalized(), Vector3(-across.normalized())})
          if (!known(triple, normal)) add_face(shape, triple, normal, flat);
      }
  require(
      !shape.faces.empty(),
      fmt::format("a shape with a spread of {:g} m has no faces that numbers of 64 bits resolve",
                  spread_of(points)));
  add_edges(shape);
  return shape;
}

}  // namespace

double ConvexShape::lowest(const Vector3& direction) const {
  double level = std::numeric_limits<double>::infinity();
  for (const Vector3& corner : corners) level = std::min(level, direction.dot(corner));
  return level;
}

double ConvexShape::level(const Face& face) const {
  return face.normal.dot(corners[static_cast<std::size_t>(face.loop.front())]);
}

SurfacePiece ConvexShape::facing(const Vector3& direction) const {
  const double level = -lowest(-direction) - kSameLevel;
  const Face* best = &faces.front();
  double best_score = 0;
  for (const Face& face : faces) {
    double score = face.normal.dot(direction);
    if (score < kEdgeOn) continue;
    for (int i : face.loop)
      if (direction.dot(corners[static_cast<std::size_t>(i)]) >= level) score += 2;
    if (score > best_score) {
      best_score = score;
      best = &face;
    }
  }
  SurfacePiece piece{{}, best->normal};
  for (int i : best->loop) piece.outline.push_back(corners[static_cast<std::size_t>(i)]);
  return piece;
}

ConvexShape ConvexShape::placed(const Quaternion& rotation, const Vector3& position) const {
  ConvexShape result = *this;
  place(rotation, position, result);
  return result;
}

void ConvexShape::place(const Quaternion& rotation, const Vector3& position,
                        ConvexShape& result) const {
  const Matrix3 r = rotation.toRotationMatrix();
  for (std::size_t i = 0; i < corners.size(); ++i) result.corners[i] = position + r * corners[i];
  for (std::size_t i = 0; i < faces.size(); ++i) result.faces[i].normal = r * faces[i].normal;
  for (std::size_t i = 0; i < edges.size(); ++i) result.edges[i] = r * edges[i];
}

ConvexShape convex_box(const Vector3& center, const Vector3& size) {
  std::vector<Vector3> corners;
  for (int k = 0; k < 8; ++k) {
    const Vector3 side(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    corners.push_back(center + 0.5 * side.cwiseProduct(size));
  }
  return hull_of(corners, kExact * size.minCoeff());
}

ConvexShape convex_hull(const std::vector<Vector3>& points) {
  return hull_of(points, std::min(kFlat, kFlatPart * spread_of(points)));
}

ConvexShape convex_body(const std::vector<Vector3>& points) {
  return hull_of(points, kFlatOfBody * spread_of(points));
}

std::vector<Vector3> corners_of(const ConvexShape& shape) {
  std::vector<bool> taken(shape.corners.size(), false);
  for (const ConvexShape::Face& face : shape.faces)
    for (int i : face.loop) taken[static_cast<std::size_t>(i)] = true;
  std::vector<Vector3> corners;
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (taken[i]) corners.push_back(shape.corners[i]);
  return corners;
}

}  // namespace gurney
