#include "engine/bullet/room_objects.h"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>

#include "engine/bullet/convert.h"
#include "engine/bullet/multibody_item.h"

namespace gurney {
namespace {

std::unique_ptr<btConvexShape> hull(const std::vector<Vector3>& points) {
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Vector3& point : points) shape->addPoint(to_bullet(point), false);
  shape->recalcLocalAabb();
  shape->setMargin(0);  // it would be added around the points
  return shape;
}

std::unique_ptr<btConvexShape> shape_of(const RoomBox& box) {
  std::vector<Vector3> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back(
        0.5 * Vector3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1).cwiseProduct(box.size));
  return hull(corners);
}

std::unique_ptr<btConvexShape> shape_of(const RoomColumn& column) {
  return std::make_unique<btCylinderShapeZ>(
      btVector3(column.radius, column.radius, 0.5 * column.height));
}

std::unique_ptr<btConvexShape> shape_of(const RoomHull& points) { return hull(points.points); }

}  // namespace

RoomObjects::RoomObjects(const std::vector<RoomShape>& room, btDynamicsWorld& world)
    : world_(world) {
  for (std::size_t i = 0; i < room.size(); ++i) {
    shapes_.push_back(std::visit([](const auto& s) { return shape_of(s); }, room[i].shape));
    auto object = std::make_unique<btCollisionObject>();
    object->setCollisionShape(shapes_.back().get());
    object->setWorldTransform(
        btTransform(to_bullet(room[i].rotation), to_bullet(room[i].position)));
    object->setUserIndex(static_cast<int>(i) + 1);
    // The chassis against the room is analytic: ChassisPoints.
    world_.addCollisionObject(object.get(), MultibodyItem::kRoom, MultibodyItem::kCasters);
    objects_.push_back(std::move(object));
  }
}

RoomObjects::~RoomObjects() {
  for (auto& object : objects_) world_.removeCollisionObject(object.get());
}

}  // namespace gurney
