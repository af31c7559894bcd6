#include "engine/solver/wheel_clearance.h"

#include <algorithm>
#include <cmath>

#include "engine/solver/placed_shape.h"

namespace gurney {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// How far a point is from a shape at least: the shape is behind the plane of each of its faces.
double distance(const ConvexShape& shape, const Vector3& point) {
  double distance = -kFar;
  for (const ConvexShape::Face& face : shape.faces)
    distance = std::max(distance, face.normal.dot(point) - shape.level(face));
  return distance;
}

double distance(const Cylinder& column, const Vector3& point) {
  const Vector3 from = point - column.center;
  const double along = column.axis.dot(from);
  return std::max(std::abs(along) - column.half_height,
                  (from - along * column.axis).norm() - column.radius);
}

double distance(const Sphere& sphere, const Vector3& point) {
  return (point - sphere.center).norm() - sphere.radius;
}

double distance(const BodyForm& form, const Vector3& point) {
  return std::visit([&](const auto& of_kind) { return distance(of_kind, point); }, form);
}

}  // namespace

WheelClearance::WheelClearance(const Scene& scene, const Assembly& assembly)
    : assembly_(assembly),
      from_room_(scene.items.size()),
      between_(scene.items.size() * scene.items.size()) {
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    auto& shapes = shapes_.emplace_back();
    for (const BodyShape& shape : scene.items[i].model.shape)
      shapes.push_back(body_form(shape, assembly.items[i].chassis.center_of_mass));
  }
  for (const RoomShape& shape : scene.room) room_.push_back(placed_shape(shape));
}

std::vector<WheelClearance::Ball> WheelClearance::balls(std::size_t item,
                                                        const State& state) const {
  std::vector<Ball> balls;
  const Pose pose = state.pose();
  const std::vector<CasterDynamics>& casters = assembly_.items[item].casters;
  for (std::size_t k = 0; k < casters.size(); ++k)
    balls.push_back({state.position + casters[k].point(pose, state.casters[k].swivel_angle,
                                                       casters[k].wheel_center()),
                     std::hypot(casters[k].wheel_radius(), 0.5 * casters[k].wheel_width())});
  return balls;
}

double WheelClearance::gap_to_room(const std::vector<Ball>& balls) const {
  double gap = kFar;
  for (const Ball& ball : balls)
    for (const BodyForm& shape : room_)
      gap = std::min(gap, distance(shape, ball.center) - ball.radius);
  return gap;
}

double WheelClearance::gap_to_shapes(const std::vector<Ball>& balls, std::size_t other,
                                     const State& at) const {
  double gap = kFar;
  for (const Ball& ball : balls) {
    const Vector3 point = at.rotation.conjugate() * (ball.center - at.position);
    for (const BodyForm& shape : shapes_[other])
      gap = std::min(gap, distance(shape, point) - ball.radius);
  }
  return gap;
}

double WheelClearance::gap_between(std::size_t a, std::size_t b, const SceneState& state) const {
  const State &at_a = state.items[a], &at_b = state.items[b];
  const double around =
      (at_a.position - at_b.position).norm() - assembly_.items[a].reach - assembly_.items[b].reach;
  const std::vector<Ball> of_a = balls(a, at_a), of_b = balls(b, at_b);
  double gap = std::min(gap_to_shapes(of_a, b, at_b), gap_to_shapes(of_b, a, at_a));
  for (const Ball& p : of_a)
    for (const Ball& q : of_b)
      gap = std::min(gap, (p.center - q.center).norm() - p.radius - q.radius);
  return std::max(gap, around);
}

bool WheelClearance::any_near(const SceneState& state, const Travels& travels, double range) {
  const std::size_t count = shapes_.size();
  const auto travelled = [&](std::size_t i) {
    const Travel& travel = travels.of(i);
    return travel.chassis(assembly_.items[i].reach) + travel.swing;
  };
  const auto near = [&](Clearance& clearance, double here, const auto& gap) {
    if (clearance.exceeds(range, here)) return false;
    const double now = gap();
    clearance.measure(now, here);
    return !(now > range + Clearance::kRounding);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const double of_i = travelled(i);
    if (!room_.empty() &&
        near(from_room_[i], of_i, [&] { return gap_to_room(balls(i, state.items[i])); }))
      return true;
    for (std::size_t j = i + 1; j < count; ++j)
      if (!assembly_.joined(i, j) && near(between_[i * count + j], of_i + travelled(j),
                                          [&] { return gap_between(i, j, state); }))
        return true;
  }
  return false;
}

}  // namespace gurney
