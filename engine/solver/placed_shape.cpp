#include "engine/solver/placed_shape.h"

namespace gurney {

BodyForm placed_shape(const RoomShape& room) {
  if (const auto* column = std::get_if<RoomColumn>(&room.shape))
    return Cylinder{room.position, room.rotation * Vector3::UnitZ(), column->radius,
                    0.5 * column->height};
  const auto* box = std::get_if<RoomBox>(&room.shape);
  const ConvexShape shape = box ? convex_box(Vector3::Zero(), box->size)
                                : convex_hull(std::get<RoomHull>(room.shape).points);
  return shape.placed(room.rotation, room.position);
}

}  // namespace gurney
