#include "engine/contact/convex_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gurney {
namespace {

/// An axis of a, or of two edges, is taken only when it is better by this: the choice between equal
/// ones does not flicker [m].
constexpr double kClearlyBetter = 1e-6;
/// Corners this near to the outermost one touch with it [m].
constexpr double kSameLevel = 1e-6;
/// A point on the outline counts as inside; points nearer than this are one [m].
constexpr double kOnOutline = 1e-9;
constexpr double kParallel = 1e-6;  // sine of the angle

double lowest(const ConvexShape& shape, const Vector3& direction) {
  double level = std::numeric_limits<double>::infinity();
  for (const Vector3& corner : shape.corners) level = std::min(level, direction.dot(corner));
  return level;
}

double highest(const ConvexShape& shape, const Vector3& direction) {
  return -lowest(shape, -direction);
}

/// Collects axes and chooses one.
class AxisChoice {
 public:
  AxisChoice(const Vector3& motion, double margin) : motion_(motion), margin_(margin) {}

  /// @returns false when the bodies are farther apart than the margin
  bool consider(const Vector3& normal, double gap, double handicap) {
    if (!(gap <= margin_)) return false;
    if (gap > gap_ + handicap) {
      gap_ = gap;
      widest_ = normal;
    }
    if (gap > 0) {
      const double approach = -normal.dot(motion_);
      if (!(approach > gap)) {
        stays_apart_ = true;
      } else if (gap / approach > entry_ + handicap / approach) {
        entry_ = gap / approach;
        last_ = normal;
      }
    }
    return true;
  }

  bool meets() const { return gap_ > 0 && !stays_apart_; }
  const Vector3& normal() const { return meets() ? last_ : widest_; }
  /// Displacement of a until they meet.
  Vector3 shift() const { return meets() ? Vector3(entry_ * motion_) : Vector3::Zero(); }

 private:
  Vector3 motion_;
  double margin_;
  Vector3 widest_ = Vector3::UnitZ(), last_ = Vector3::UnitZ();
  double gap_ = -std::numeric_limits<double>::infinity(), entry_ = 0;
  bool stays_apart_ = false;
};

bool choose_axis(const ConvexShape& a, const ConvexShape& b, AxisChoice& choice) {
  const auto corner = [](const ConvexShape& shape, const ConvexShape::Face& face) {
    return shape.corners[static_cast<std::size_t>(face.loop.front())];
  };
  for (const ConvexShape::Face& face : b.faces) {
    const double gap = lowest(a, face.normal) - face.normal.dot(corner(b, face));
    if (!choice.consider(face.normal, gap, 0)) return false;
  }
  for (const ConvexShape::Face& face : a.faces) {
    const double gap = lowest(b, face.normal) - face.normal.dot(corner(a, face));
    if (!choice.consider(-face.normal, gap, kClearlyBetter)) return false;
  }
  for (const Vector3& edge_a : a.edges)
    for (const Vector3& edge_b : b.edges) {
      const Vector3 across = edge_a.cross(edge_b);
      const double size = across.norm();
      if (size < kParallel) continue;
      for (const Vector3& normal : {Vector3(across / size), Vector3(-across / size)}) {
        const double gap = lowest(a, normal) - highest(b, normal);
        if (!choice.consider(normal, gap, kClearlyBetter)) return false;
      }
    }
  return true;
}

/// The face that holds most of the corners farthest along `direction`; of equal ones the one that
/// looks there most.
const ConvexShape::Face& facing(const ConvexShape& shape, const Vector3& direction) {
  const double level = highest(shape, direction) - kSameLevel;
  const ConvexShape::Face* best = &shape.faces.front();
  double best_score = -std::numeric_limits<double>::infinity();
  for (const ConvexShape::Face& face : shape.faces) {
    const double look = face.normal.dot(direction);
    if (look < kParallel) continue;
    double score = look;
    for (int i : face.loop)
      if (direction.dot(shape.corners[static_cast<std::size_t>(i)]) >= level) score += 2;
    if (score > best_score) {
      best_score = score;
      best = &face;
    }
  }
  return *best;
}

/// A face seen along the normal: its outline in the plane across, and its height above that.
struct View {
  std::vector<Vector2> outline;
  Vector2 slope;
  double level;

  View(const ConvexShape& shape, const ConvexShape::Face& face, const Matrix3& frame,
       const Vector3& shift) {
    for (int i : face.loop)
      outline.push_back(frame.topRows<2>() * (shape.corners[static_cast<std::size_t>(i)] + shift));
    const Vector3 n = frame * face.normal;
    slope = -n.head<2>() / n.z();
    const Vector3 first = frame * (shape.corners[static_cast<std::size_t>(face.loop[0])] + shift);
    level = first.z() - slope.dot(first.head<2>());
  }
  double height(const Vector2& at) const { return level + slope.dot(at); }
};

/// The part of a convex polygon inside another, which runs counterclockwise (Sutherland & Hodgman
/// 1974).
std::vector<Vector2> common(std::vector<Vector2> polygon, const std::vector<Vector2>& other) {
  std::vector<Vector2> kept;
  for (std::size_t k = 0; k < other.size() && !polygon.empty(); ++k) {
    const Vector2 from = other[k], along = (other[(k + 1) % other.size()] - from).normalized();
    const Vector2 inwards(-along.y(), along.x());
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double at_p = inwards.dot(p - from), at_q = inwards.dot(q - from);
      if (at_p >= -kOnOutline) kept.push_back(p);
      if ((at_p > kOnOutline && at_q < -kOnOutline) || (at_p < -kOnOutline && at_q > kOnOutline))
        kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    polygon = kept;
  }
  return polygon;
}

}  // namespace

void convex_points(const ConvexShape& a, const ConvexShape& b, const Vector3& motion, double margin,
                   std::vector<ConvexPoint>& points) {
  AxisChoice choice(motion, margin);
  if (!choose_axis(a, b, choice)) return;
  const Vector3 normal = choice.normal(), shift = choice.shift();
  Matrix3 frame;
  frame.row(2) = normal.transpose();
  frame.row(0) = normal.unitOrthogonal().transpose();
  frame.row(1) = frame.row(2).cross(frame.row(0));
  const View on_a(a, facing(a, -normal), frame, shift);
  const View on_b(b, facing(b, normal), frame, Vector3::Zero());
  std::vector<Vector2> seen;
  for (const Vector2& at : common(on_a.outline, on_b.outline)) {
    const bool known = std::any_of(seen.begin(), seen.end(), [&](const Vector2& s) {
      return (s - at).norm() < 2 * kOnOutline;
    });
    if (known) continue;
    seen.push_back(at);
    ConvexPoint point;
    point.on_a = frame.transpose() * Vector3(at.x(), at.y(), on_a.height(at)) - shift;
    point.on_b = frame.transpose() * Vector3(at.x(), at.y(), on_b.height(at));
    point.normal = normal;
    point.gap = normal.dot(point.on_a - point.on_b);
    if (point.gap <= margin) points.push_back(point);
  }
}

}  // namespace gurney
