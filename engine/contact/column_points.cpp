#include "engine/contact/column_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/contact/axis_choice.h"

namespace gurney {
namespace {

enum Kind { kFace, kEdge };

/// An axis nearer to the column's than 45 degrees meets an end.
constexpr double kEnd = std::numbers::sqrt2 / 2;
constexpr int kRimPoints = 16;       // of a column at rest
constexpr double kSamePoint = 1e-6;  // [m]
/// Edges that lean less against the column are along it: sine of the angle.
constexpr double kAlong = 1e-3;
constexpr double kParallel = 1e-6;

Vector3 across_axis(const Cylinder& column, const Vector3& v) { return column.across(v); }

bool choose_axis(const ConvexShape& a, const Cylinder& b, AxisChoice& choice) {
  const auto consider = [&](const Vector3& normal, double handicap, Kind kind) {
    return choice.consider(normal, a.lowest(normal) + b.lowest(-normal), handicap, kind);
  };
  for (const Vector3& end : {b.axis, Vector3(-b.axis)})
    if (!consider(end, 0, kFace)) return false;
  for (const ConvexShape::Face& face : a.faces)
    if (!consider(-face.normal, 0, kFace)) return false;
  for (const Vector3& corner : a.corners) {
    const Vector3 away = across_axis(b, corner - b.center);
    if (away.norm() < kParallel * b.radius) continue;
    if (!consider(away.normalized(), AxisChoice::kHandicap, kEdge)) return false;
  }
  for (const Vector3& edge : a.edges) {
    const Vector3 across = edge.cross(b.axis);
    if (across.norm() < kParallel) continue;
    for (const Vector3& normal : {across.normalized(), Vector3(-across.normalized())})
      if (!consider(normal, AxisChoice::kHandicap, kEdge)) return false;
  }
  return true;
}

/// The end or the line of the side that looks along `direction`.
SurfacePiece facing(const Cylinder& column, const Vector3& direction) {
  const double along = column.axis.dot(direction);
  const Vector3 across = across_axis(column, direction);
  const Vector3 out =
      across.norm() > kParallel ? across.normalized() : column.axis.unitOrthogonal();
  const Vector3 up = column.half_height * column.axis, side = column.radius * out;
  if (std::abs(along) <= kEnd) return {{column.center + side - up, column.center + side + up}, out};
  SurfacePiece end{{}, std::copysign(1.0, along) * column.axis};
  if (!column.rim.isZero()) {
    const auto rim = column.rim_points(along > 0 ? 1 : -1);
    end.outline.assign(rim.begin(), rim.end());
    return end;
  }
  const Vector3 other = end.normal.cross(side);
  for (int k = 0; k < kRimPoints; ++k) {
    const double angle = 2 * std::numbers::pi * k / kRimPoints;
    end.outline.push_back(column.center + column.half_height * end.normal + std::cos(angle) * side +
                          std::sin(angle) * other);
  }
  return end;
}

struct Edge {
  Vector3 from, to;
};

/// Edge of `a` most along the column, at the corner of `a` that is lowest along `normal`.
Edge leading_edge(const ConvexShape& a, const Vector3& normal, const Cylinder& b) {
  const auto corner = [&](int i) { return a.corners[static_cast<std::size_t>(i)]; };
  int lowest = 0;
  for (int i = 1; i < static_cast<int>(a.corners.size()); ++i)
    if (normal.dot(corner(i)) < normal.dot(corner(lowest))) lowest = i;
  Edge best{corner(lowest), corner(lowest)};
  double best_along = -1;
  for (const ConvexShape::Face& face : a.faces)
    for (std::size_t k = 0; k < face.loop.size(); ++k) {
      if (face.loop[k] != lowest) continue;
      const Vector3 next = corner(face.loop[(k + 1) % face.loop.size()]);
      const double along = std::abs(b.axis.dot((next - corner(lowest)).normalized()));
      if (along > best_along) {
        best_along = along;
        best.to = next;
      }
    }
  return best;
}

/// Points of an edge beside the column, each against the side there.
void edge_points(const Edge& edge, const Cylinder& b, const Vector3& shift, double margin,
                 std::vector<FacingPoint>& points) {
  const Vector3 from = edge.from + shift - b.center, run = edge.to - edge.from;
  const double start = b.axis.dot(from), rise = b.axis.dot(run);
  double first = 0, last = 1;
  if (std::abs(rise) > kParallel * run.norm()) {
    const double low = (-b.half_height - start) / rise, high = (b.half_height - start) / rise;
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  } else if (std::abs(start) > b.half_height) {
    return;
  }
  if (!(first <= last)) return;
  std::vector<double> places{first};
  if (last > first && run.norm() > 0) places.push_back(last);
  const Vector3 sideways = across_axis(b, run);
  if (sideways.norm() > kAlong * run.norm()) {
    const double nearest = -sideways.dot(across_axis(b, from)) / sideways.squaredNorm();
    if (nearest > first && nearest < last) places.push_back(nearest);
  }
  for (double place : places) {
    const Vector3 on_a = edge.from + place * run;
    const Vector3 away = across_axis(b, on_a + shift - b.center);
    if (!(away.norm() > 0)) continue;
    const Vector3 normal = away.normalized();
    const Vector3 on_b = on_a + shift - away + b.radius * normal;
    const double gap = normal.dot(on_a - on_b);
    if (gap <= margin) points.push_back({on_a, on_b, normal, gap});
  }
}

/// Points on an end of a body that moves: those it keeps while it stands nearly flat, and its lowest
/// point once it is tilted.
void end_points(const SurfacePiece& a, const Cylinder& b, const Vector3& normal,
                const Vector3& shift, double margin, std::vector<FacingPoint>& points) {
  const SurfacePiece end = facing(b, normal);
  const std::size_t before = points.size();
  facing_points(a, end, normal, shift, margin, points);
  const Vector3 out = b.across(normal);
  const double tilt = out.norm();
  const auto is_of_rim = [&](const FacingPoint& point) {
    return std::ranges::any_of(end.outline, [&](const Vector3& corner) {
      return (point.on_b - corner).norm() < kSamePoint;
    });
  };
  if (tilt >= Cylinder::kFlat)
    points.erase(std::remove_if(points.begin() + static_cast<std::ptrdiff_t>(before), points.end(),
                                is_of_rim),
                 points.end());
  if (tilt < Cylinder::kTilted) return;
  const Vector3 lowest = b.center + b.half_height * end.normal + (b.radius / tilt) * out;
  const std::size_t kept = points.size();
  facing_points(a, {{lowest}, end.normal}, normal, shift, margin, points);
  for (std::size_t i = kept; i < points.size(); ++i) points[i].rolls_b = true;
}

}  // namespace

double Cylinder::lowest(const Vector3& direction) const {
  return direction.dot(center) - half_height * std::abs(direction.dot(axis)) -
         radius * across(direction).norm();
}

std::array<Vector3, Cylinder::kRimPoints> Cylinder::rim_points(int end) const {
  const Vector3 outwards = end * axis, middle = center + half_height * outwards;
  const Vector3 other = outwards.cross(rim);
  std::array<Vector3, kRimPoints> points;
  for (std::size_t k = 0; k < kRimPoints; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kRimPoints;
    points[k] = middle + radius * (std::cos(angle) * rim + std::sin(angle) * other);
  }
  return points;
}

void column_points(const ConvexShape& a, const Cylinder& b, const Vector3& motion, double margin,
                   std::vector<FacingPoint>& points) {
  AxisChoice choice(motion, margin);
  if (!choose_axis(a, b, choice)) return;
  const Vector3& normal = choice.normal();
  const Vector3 shift = choice.shift();
  const bool moves = !b.rim.isZero();
  const std::size_t before = points.size();
  if (choice.kind() == kEdge) {
    edge_points(leading_edge(a, normal, b), b, shift, margin, points);
  } else if (moves && std::abs(b.axis.dot(normal)) > kEnd) {
    return end_points(a.facing(-normal), b, normal, shift, margin, points);
  } else {
    facing_points(a.facing(-normal), facing(b, normal), normal, shift, margin, points);
  }
  if (moves)
    for (std::size_t i = before; i < points.size(); ++i) points[i].rolls_b = true;
}

}  // namespace gurney
