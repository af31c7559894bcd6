#include "engine/solver/chassis_points.h"

#include <algorithm>

#include "engine/contact/convex_points.h"
#include "engine/solver/placed_shape.h"

namespace gurney {
namespace {

double reach_of(const std::variant<ConvexShape, Cylinder>& shape, const Vector3& center) {
  if (const auto* column = std::get_if<Cylinder>(&shape))
    return std::hypot(column->radius, column->half_height);
  double reach = 0;
  for (const Vector3& corner : std::get<ConvexShape>(shape).corners)
    reach = std::max(reach, (corner - center).norm());
  return reach;
}

}  // namespace

ChassisPoints::ChassisPoints(const Scene& scene, const Assembly& assembly) {
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const Vector3& center = assembly.items[i].chassis.center_of_mass;
    auto& boxes = boxes_.emplace_back();
    double& reach = reach_.emplace_back(0);
    for (const Box& box : scene.items[i].model.shape) {
      boxes.push_back(convex_box(box.center - center, box.size));
      reach = std::max(reach, (box.center - center).norm() + 0.5 * box.size.norm());
    }
  }
  for (std::size_t i = 0; i < scene.room.size(); ++i) {
    Obstacle obstacle{static_cast<int>(i) + 1, placed_shape(scene.room[i]), scene.room[i].position,
                      0};
    obstacle.reach = reach_of(obstacle.shape, obstacle.center);
    obstacles_.push_back(std::move(obstacle));
  }
}

std::vector<ChassisPoints::PlacedBox> ChassisPoints::placed(std::size_t item,
                                                            const State& state) const {
  std::vector<PlacedBox> boxes;
  for (const ConvexShape& box : boxes_[item]) {
    PlacedBox here{box.placed(state.rotation, state.position), {}, {}, 0};
    const Vector3 &low = here.shape.corners.front(), &high = here.shape.corners.back();
    here.center = 0.5 * (low + high);
    here.reach = 0.5 * (high - low).norm();
    here.velocity = state.velocity.chassis.head<3>() +
                    state.velocity.chassis.tail<3>().cross(here.center - state.position);
    boxes.push_back(std::move(here));
  }
  return boxes;
}

void ChassisPoints::against_room(std::size_t item, const State& state,
                                 const std::vector<PlacedBox>& boxes, double step, double margin,
                                 std::vector<BodyContact>& contacts) const {
  std::vector<FacingPoint> points;
  for (const PlacedBox& box : boxes)
    for (const Obstacle& obstacle : obstacles_) {
      if ((box.center - obstacle.center).norm() > box.reach + obstacle.reach + margin) continue;
      points.clear();
      const Vector3 motion = step * box.velocity;
      if (const auto* column = std::get_if<Cylinder>(&obstacle.shape))
        column_points(box.shape, *column, motion, margin, points);
      else
        convex_points(box.shape, std::get<ConvexShape>(obstacle.shape), motion, margin, points);
      for (const FacingPoint& point : points) {
        BodyContact& contact = contacts.emplace_back();
        contact.side = {item, -1, state.rotation.conjugate() * (point.on_a - state.position)};
        contact.other = obstacle.other;
        contact.normal = point.normal;
        contact.offset = point.normal.dot(point.on_b);
      }
    }
}

void ChassisPoints::between(std::size_t a, const std::vector<PlacedBox>& boxes_a, std::size_t b,
                            const std::vector<PlacedBox>& boxes_b, const SceneState& state,
                            double step, double margin, std::vector<BodyContact>& contacts) const {
  std::vector<FacingPoint> points;
  for (const PlacedBox& first : boxes_a)
    for (const PlacedBox& second : boxes_b) {
      if ((first.center - second.center).norm() > first.reach + second.reach + margin) continue;
      points.clear();
      convex_points(first.shape, second.shape, step * (first.velocity - second.velocity), margin,
                    points);
      for (const FacingPoint& point : points) {
        const State &at_a = state.items[a], &at_b = state.items[b];
        BodyContact& contact = contacts.emplace_back();
        contact.side = {a, -1, at_a.rotation.conjugate() * (point.on_a - at_a.position)};
        contact.other = BodyContact::kItem;
        contact.other_side = {b, -1, at_b.rotation.conjugate() * (point.on_b - at_b.position)};
        contact.normal = point.normal;
      }
    }
}

void ChassisPoints::collect(const SceneState& state, double step, double margin,
                            std::vector<BodyContact>& contacts) const {
  const std::size_t count = boxes_.size();
  if (obstacles_.empty() && count == 1) return;
  std::vector<std::vector<PlacedBox>> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(placed(i, state.items[i]));
  for (std::size_t i = 0; i < count; ++i) {
    against_room(i, state.items[i], boxes[i], step, margin, contacts);
    for (std::size_t j = i + 1; j < count; ++j) {
      const double distance = (state.items[i].position - state.items[j].position).norm();
      if (distance > reach_[i] + reach_[j] + margin) continue;
      between(i, boxes[i], j, boxes[j], state, step, margin, contacts);
    }
  }
}

}  // namespace gurney
