#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletDynamics/Dynamics/btDynamicsWorld.h>

#include <memory>
#include <vector>

#include "engine/scene/room.h"

namespace gurney {

/// The room as Bullet holds it: one static collision object for each shape, in group kRoom, with
/// user index i + 1.
///
/// Wheels meet them; the chassis' contacts with the room are analytic (ChassisPoints). Boxes are
/// convex hulls with their faces known.
class RoomObjects {
 public:
  RoomObjects(const std::vector<RoomShape>& room, btDynamicsWorld& world);
  ~RoomObjects();
  RoomObjects(const RoomObjects&) = delete;
  RoomObjects& operator=(const RoomObjects&) = delete;

 private:
  btDynamicsWorld& world_;
  std::vector<std::unique_ptr<btConvexShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
};

}  // namespace gurney
