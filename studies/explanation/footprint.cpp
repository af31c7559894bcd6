#include "studies/explanation/footprint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gurney::explanation {
namespace {

double turn(const Vector2& a, const Vector2& b, const Vector2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Whether an edge of `a` has all of `b` outside.
bool separates(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector2 &from = a[i], &to = a[(i + 1) % a.size()];
    if (std::all_of(b.begin(), b.end(), [&](const Vector2& p) { return turn(from, to, p) <= 0; }))
      return true;
  }
  return false;
}

std::vector<Vector3> points_of(const RoomBox& box) {
  return outline_points({Vector3::Zero(), box.size});
}

std::vector<Vector3> points_of(const RoomColumn& column) {
  constexpr int kSides = 48;
  std::vector<Vector3> points;
  for (int i = 0; i < kSides; ++i)
    for (const double z : {-0.5 * column.height, 0.5 * column.height}) {
      const double angle = 2 * std::numbers::pi * i / kSides;
      points.emplace_back(column.radius * std::cos(angle), column.radius * std::sin(angle), z);
    }
  return points;
}

std::vector<Vector3> points_of(const RoomHull& hull) { return hull.points; }

Polygon from_above(const std::vector<Vector3>& points, const Vector3& origin,
                   const Quaternion& rotation) {
  std::vector<Vector2> plan;
  for (const Vector3& point : points) plan.push_back((origin + rotation * point).head<2>());
  return convex_polygon(std::move(plan));
}

}  // namespace

std::vector<Polygon> footprint(const PlacedItem& item, const Sample& sample) {
  const Vector3 start(item.initial.position.x(), item.initial.position.y(), 0);
  std::vector<Polygon> result;
  for (const BodyShape& shape : item.model.shape)
    result.push_back(from_above(outline_points(shape), start + sample.origin_displacement(),
                                sample.orientation));
  return result;
}

Polygon footprint(const RoomShape& shape) {
  return from_above(std::visit([](const auto& s) { return points_of(s); }, shape.shape),
                    shape.position, shape.rotation);
}

Polygon footprint(const Zone& zone) {
  const Eigen::Rotation2Dd rotation(zone.angle);
  Polygon corners;
  for (const Vector2& sign : {Vector2(-1, -1), Vector2(1, -1), Vector2(1, 1), Vector2(-1, 1)})
    corners.push_back(zone.center +
                      rotation * (0.5 * sign.cwiseProduct(Vector2(zone.length, zone.width))));
  return corners;
}

bool overlap(const Polygon& a, const Polygon& b) { return !separates(a, b) && !separates(b, a); }

const Sample& last_finite(const std::vector<Sample>& history) {
  const auto finite = [](const Sample& sample) {
    return sample.displacement.allFinite() && sample.orientation.coeffs().allFinite() &&
           std::isfinite(sample.yaw) &&
           std::all_of(sample.wheels.begin(), sample.wheels.end(),
                       [](const WheelSample& w) { return std::isfinite(w.swivel_angle); });
  };
  const auto found = std::find_if(history.rbegin(), history.rend(), finite);
  return found == history.rend() ? history.front() : *found;
}

}  // namespace gurney::explanation
