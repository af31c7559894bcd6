#include "engine/solver/room_points.h"

#include "engine/contact/convex_points.h"

namespace gurney {
namespace {

std::variant<ConvexShape, Column> placed(const RoomShape& room) {
  if (const auto* column = std::get_if<RoomColumn>(&room.shape))
    return Column{room.position, room.rotation * Vector3::UnitZ(), column->radius,
                  0.5 * column->height};
  const auto* box = std::get_if<RoomBox>(&room.shape);
  const ConvexShape shape = box ? convex_box(Vector3::Zero(), box->size)
                                : convex_hull(std::get<RoomHull>(room.shape).points);
  return shape.placed(room.rotation, room.position);
}

}  // namespace

RoomPoints::RoomPoints(const Scene& scene, const Mechanism& mechanism) {
  for (const Box& box : scene.item.shape)
    boxes_.push_back(convex_box(box.center - mechanism.chassis.center_of_mass, box.size));
  for (std::size_t i = 0; i < scene.room.size(); ++i)
    obstacles_.push_back({static_cast<int>(i) + 1, placed(scene.room[i])});
}

void RoomPoints::collect(const State& state, double step, double margin,
                         std::vector<BodyContact>& contacts) const {
  if (obstacles_.empty()) return;
  const Vector3 velocity = state.velocity.chassis.head<3>();
  const Vector3 turning = state.velocity.chassis.tail<3>();
  const Quaternion to_chassis = state.rotation.conjugate();
  std::vector<FacingPoint> points;
  for (const ConvexShape& box : boxes_) {
    const ConvexShape here = box.placed(state.rotation, state.position);
    const Vector3 arm = 0.5 * (here.corners.front() + here.corners.back()) - state.position;
    const Vector3 motion = step * (velocity + turning.cross(arm));
    for (const Obstacle& obstacle : obstacles_) {
      points.clear();
      if (const auto* column = std::get_if<Column>(&obstacle.shape))
        column_points(here, *column, motion, margin, points);
      else
        convex_points(here, std::get<ConvexShape>(obstacle.shape), motion, margin, points);
      for (const FacingPoint& point : points)
        contacts.push_back({.other = obstacle.other,
                            .local = to_chassis * (point.on_a - state.position),
                            .normal = point.normal,
                            .offset = point.normal.dot(point.on_b)});
    }
  }
}

}  // namespace gurney
