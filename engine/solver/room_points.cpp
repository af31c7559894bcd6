#include "engine/solver/room_points.h"

#include "engine/contact/convex_points.h"

namespace gurney {

RoomPoints::RoomPoints(const Scene& scene, const Mechanism& mechanism) {
  for (const Box& box : scene.item.shape)
    boxes_.push_back(convex_box(box.center - mechanism.chassis.center_of_mass, box.size));
  for (std::size_t i = 0; i < scene.room.size(); ++i) {
    const RoomShape& room = scene.room[i];
    const auto add = [&](const ConvexShape& shape) {
      obstacles_.push_back({static_cast<int>(i) + 1, shape.placed(room.rotation, room.position)});
    };
    if (const auto* box = std::get_if<RoomBox>(&room.shape))
      add(convex_box(Vector3::Zero(), box->size));
    else if (const auto* hull = std::get_if<RoomHull>(&room.shape))
      add(convex_hull(hull->points));
  }
}

void RoomPoints::collect(const State& state, double step, double margin,
                         std::vector<BodyContact>& contacts) const {
  if (obstacles_.empty()) return;
  const Vector3 velocity = state.velocity.chassis.head<3>();
  const Vector3 turning = state.velocity.chassis.tail<3>();
  const Quaternion to_chassis = state.rotation.conjugate();
  std::vector<ConvexPoint> points;
  for (const ConvexShape& box : boxes_) {
    const ConvexShape placed = box.placed(state.rotation, state.position);
    const Vector3 arm = 0.5 * (placed.corners.front() + placed.corners.back()) - state.position;
    const Vector3 motion = step * (velocity + turning.cross(arm));
    for (const Obstacle& obstacle : obstacles_) {
      points.clear();
      convex_points(placed, obstacle.shape, motion, margin, points);
      for (const ConvexPoint& point : points)
        contacts.push_back({.other = obstacle.other,
                            .local = to_chassis * (point.on_a - state.position),
                            .normal = point.normal,
                            .offset = point.normal.dot(point.on_b)});
    }
  }
}

}  // namespace gurney
