#include "engine/contact/facing_points.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace gurney {
namespace {

/// A point this near to an outline is inside; points nearer than twice this are one [m].
constexpr double kOnOutline = 1e-9;

/// A piece seen along the normal: its outline in the plane across, and its height above that.
struct View {
  std::vector<Vector2> outline;
  Vector2 slope;
  double level;

  View(const SurfacePiece& piece, const Matrix3& frame, const Vector3& shift) {
    for (const Vector3& corner : piece.outline)
      outline.push_back(frame.topRows<2>() * (corner + shift));
    const Vector3 n = frame * piece.normal;
    slope = -n.head<2>() / n.z();
    const Vector3 first = frame * (piece.outline.front() + shift);
    level = first.z() - slope.dot(first.head<2>());
  }
  double height(const Vector2& at) const { return level + slope.dot(at); }
};

/// The part of a polygon or segment inside a polygon that runs counterclockwise (Sutherland &
/// Hodgman 1974).
std::vector<Vector2> common(std::vector<Vector2> piece, const std::vector<Vector2>& polygon) {
  std::vector<Vector2> kept;
  for (std::size_t k = 0; k < polygon.size() && !piece.empty(); ++k) {
    const Vector2 from = polygon[k],
                  along = (polygon[(k + 1) % polygon.size()] - from).normalized();
    const Vector2 inwards(-along.y(), along.x());
    kept.clear();
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const Vector2 &p = piece[i], &q = piece[(i + 1) % piece.size()];
      const double at_p = inwards.dot(p - from), at_q = inwards.dot(q - from);
      if (at_p >= -kOnOutline) kept.push_back(p);
      if ((at_p > kOnOutline && at_q < -kOnOutline) || (at_p < -kOnOutline && at_q > kOnOutline))
        kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    piece = kept;
  }
  return piece;
}

std::vector<Vector2> common(const View& a, const View& b) {
  if (b.outline.size() > 2) return common(a.outline, b.outline);
  // The normal points out of b and into a: a's outline runs clockwise.
  return common(b.outline, {a.outline.rbegin(), a.outline.rend()});
}

}  // namespace

void facing_points(const SurfacePiece& a, const SurfacePiece& b, const Vector3& normal,
                   const Vector3& shift, double margin, std::vector<FacingPoint>& points) {
  Matrix3 frame;
  frame.row(2) = normal.transpose();
  frame.row(0) = normal.unitOrthogonal().transpose();
  frame.row(1) = frame.row(2).cross(frame.row(0));
  const View on_a(a, frame, shift), on_b(b, frame, Vector3::Zero());
  std::vector<Vector2> seen;
  for (const Vector2& at : common(on_a, on_b)) {
    const bool known = std::any_of(seen.begin(), seen.end(), [&](const Vector2& s) {
      return (s - at).norm() < 2 * kOnOutline;
    });
    if (known) continue;
    seen.push_back(at);
    FacingPoint point;
    point.on_a = frame.transpose() * Vector3(at.x(), at.y(), on_a.height(at)) - shift;
    point.on_b = frame.transpose() * Vector3(at.x(), at.y(), on_b.height(at));
    point.normal = normal;
    point.gap = normal.dot(point.on_a - point.on_b);
    if (point.gap <= margin) points.push_back(point);
  }
}

}  // namespace gurney
