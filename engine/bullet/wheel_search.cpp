#include "engine/bullet/wheel_search.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include <optional>
#include <utility>

#include "engine/bullet/convert.h"
#include "engine/contact/wheel_obstacle.h"
#include "engine/solver/placed_shape.h"

namespace gurney {
namespace {

/// Wheels meet everything but the floor; chassis and room meet wheels only (ChassisPoints).
enum Group : int { kChassis = 1, kWheels = 2, kRoom = 4 };

/// Pools for the pairs of a room; for more, Bullet allocates one by one. Its own are for 4096
/// pairs: megabytes that every run would write.
btDefaultCollisionConstructionInfo small_pools() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = info.m_defaultMaxCollisionAlgorithmPoolSize = 128;
  return info;
}

std::unique_ptr<btCollisionShape> hull(const std::vector<Vector3>& points) {
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Vector3& point : points) shape->addPoint(to_bullet(point), false);
  shape->recalcLocalAabb();
  shape->setMargin(0);  // it would be added around the points
  return shape;
}

std::unique_ptr<btCollisionShape> shape_of(const RoomBox& box) {
  std::vector<Vector3> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back(
        0.5 * Vector3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1).cwiseProduct(box.size));
  return hull(corners);
}

std::unique_ptr<btCollisionShape> shape_of(const RoomColumn& column) {
  return std::make_unique<btCylinderShapeZ>(
      btVector3(column.radius, column.radius, 0.5 * column.height));
}

std::unique_ptr<btCollisionShape> shape_of(const RoomHull& points) { return hull(points.points); }

std::unique_ptr<btCollisionShape> shape_of(const BodyShape& body) {
  if (const auto* cylinder = std::get_if<SolidCylinder>(&body.solid))
    return shape_of(RoomColumn{cylinder->radius, cylinder->length});
  if (const auto* sphere = std::get_if<SolidSphere>(&body.solid))
    return std::make_unique<btSphereShape>(sphere->radius);
  if (const auto* points = std::get_if<SolidHull>(&body.solid)) return hull(points->corners);
  auto box = std::make_unique<btBoxShape>(to_bullet(Vector3(0.5 * body.size)));
  box->setMargin(0.001);
  return box;
}

/// Turns Bullet's cylinder, whose axis is z.
btQuaternion axes_of(const BodyShape& body) {
  const auto* cylinder = std::get_if<SolidCylinder>(&body.solid);
  if (cylinder == nullptr) return btQuaternion::getIdentity();
  return to_bullet(Quaternion::FromTwoVectors(Vector3::UnitZ(), cylinder->axis));
}

/// An item in the middle of a step that begins at `start`.
State middle_of_step(const State& start, double step) {
  const double time = 0.5 * step;
  State state = start;
  state.position += time * start.velocity.chassis.head<3>();
  state.rotation = rotated(time * start.velocity.chassis.tail<3>(), start.rotation);
  for (std::size_t i = 0; i < state.casters.size(); ++i)
    state.casters[i].swivel_angle += time * start.velocity.joints[i][0];
  return state;
}

/// Bullet's normal of a tread before a polyhedron is a guess; of one that touches, the normal it
/// had is a better one: of a deep overlap Bullet may separate it through another face.
Vector3 guess_of(const BodyContact& contact, const SceneState& state) {
  for (const BodyContactState& memory : state.contacts)
    if (memory.compression > 0 && memory.contact.same_pair(contact)) return memory.contact.normal;
  return contact.normal;
}

}  // namespace

class WheelSearch::World {
 public:
  World(const Scene& scene, const Assembly& assembly) : assembly_(assembly) {
    for (std::size_t i = 0; i < scene.items.size(); ++i) add_item(scene.items[i].model, i);
    for (std::size_t i = 0; i < scene.room.size(); ++i) add_room(scene.room[i], i);
    // Points are reported from the same distance for shapes of every size.
    dispatcher_.setDispatcherFlags(
        dispatcher_.getDispatcherFlags() &
        ~btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);
  }

  void collect(const SceneState& state, double step, std::vector<BodyContact>& contacts) {
    for (auto& part : parts_) place(*part, state);
    forget_last_pass();
    world_.performDiscreteCollisionDetection();
    for (int m = 0; m < dispatcher_.getNumManifolds(); ++m)
      collect(*dispatcher_.getManifoldByIndexInternal(m), state, step, contacts);
  }

 private:
  /// A wheel or chassis of an item, or a shape of the room.
  struct Part {
    std::optional<BodyContact::Side> body;  ///< none: of the room
    int other = 0;                          ///< of the room: BodyContact::other
    std::unique_ptr<btCollisionShape> shape;
    std::vector<std::unique_ptr<btCollisionShape>> shapes;  ///< of a chassis
    btCollisionObject object;

    bool is_wheel() const { return body && body->caster >= 0; }
  };

  /// Bodies of one mechanism do not meet.
  Part& add(std::unique_ptr<Part> part, int group, int mask) {
    for (const auto& other : parts_) {
      if (!part->body || !other->body) continue;
      if (!assembly_.joined(part->body->item, other->body->item)) continue;
      part->object.setIgnoreCollisionCheck(&other->object, true);
      other->object.setIgnoreCollisionCheck(&part->object, true);
    }
    part->object.setCollisionShape(part->shape.get());
    part->object.setUserPointer(part.get());
    world_.addCollisionObject(&part->object, group, mask);
    parts_.push_back(std::move(part));
    return *parts_.back();
  }

  void add_item(const EquipmentModel& model, std::size_t item) {
    auto chassis = std::make_unique<Part>();
    chassis->body = BodyContact::Side{item, -1};
    auto compound = std::make_unique<btCompoundShape>();
    for (const BodyShape& body : model.shape) {
      const Vector3 center = body.center - assembly_.items[item].chassis.center_of_mass;
      auto shape = shape_of(body);
      compound->addChildShape(btTransform(axes_of(body), to_bullet(center)), shape.get());
      chassis->shapes.push_back(std::move(shape));
    }
    chassis->shape = std::move(compound);
    add(std::move(chassis), kChassis, kWheels);
    for (std::size_t i = 0; i < model.casters.size(); ++i) {
      const Caster& c = model.casters[i];
      auto wheel = std::make_unique<Part>();
      wheel->body = BodyContact::Side{item, static_cast<int>(i)};
      wheel->shape = std::make_unique<btCylinderShape>(
          btVector3(c.wheel_radius, 0.5 * c.wheel_width, c.wheel_radius));
      add(std::move(wheel), kWheels, kChassis | kWheels | kRoom);
    }
  }

  void add_room(const RoomShape& room, std::size_t index) {
    auto part = std::make_unique<Part>();
    part->other = static_cast<int>(index) + 1;
    part->shape = std::visit([](const auto& s) { return shape_of(s); }, room.shape);
    part->object.setWorldTransform(btTransform(to_bullet(room.rotation), to_bullet(room.position)));
    add(std::move(part), kRoom, kWheels);
    const auto placed = placed_shape(room);
    const auto* polyhedron = std::get_if<ConvexShape>(&placed);
    obstacles_.push_back(polyhedron ? std::optional<WheelObstacle>(*polyhedron) : std::nullopt);
  }

  void place(Part& part, const SceneState& state) const {
    if (!part.body) return;
    const State& item = state.items[part.body->item];
    Vector3 position = item.position;
    Quaternion rotation = item.rotation;
    if (part.is_wheel()) {
      const auto i = static_cast<std::size_t>(part.body->caster);
      const CasterDynamics& caster = assembly_.items[part.body->item].casters[i];
      const double angle = item.casters[i].swivel_angle;
      position += caster.point(item.pose(), angle, caster.wheel_center());
      rotation = rotation * Quaternion(Eigen::AngleAxisd(angle, Vector3::UnitZ()));
    }
    part.object.setWorldTransform(btTransform(to_bullet(rotation), to_bullet(position)));
  }

  /// A point that turned with a wheel since the last pass is no contact any more, and Bullet's
  /// search would start from the axis it found then: results would depend on which passes are
  /// skipped.
  void forget_last_pass() {
    btOverlappingPairCache& cache = *broadphase_.getOverlappingPairCache();
    for (int i = 0; i < cache.getNumOverlappingPairs(); ++i)
      cache.cleanOverlappingPair(cache.getOverlappingPairArray()[i], &dispatcher_);
  }

  /// @param towards  unit, outwards of the body
  BodyContact::Side side_at(const State& state, const BodyContact::Side& body, const Vector3& point,
                            const Vector3& towards) const {
    BodyContact::Side side = body;
    if (body.caster < 0) {
      side.local = state.rotation.conjugate() * (point - state.position);
      return side;
    }
    const auto i = static_cast<std::size_t>(body.caster);
    const CasterDynamics& wheel = assembly_.items[body.item].casters[i];
    const Pose pose = state.pose();
    const double angle = state.casters[i].swivel_angle;
    const Vector3 origin = wheel.point(pose, angle, Vector3::Zero());
    const Vector3 direction = wheel.on_fork(pose, angle, origin + towards);
    side.local = wheel.tread_point(direction, wheel.on_fork(pose, angle, point - state.position));
    return side;
  }

  /// A tread before a polyhedron. The plane stays for the step: that of its middle errs alike at
  /// both ends, so that the next one takes over without a jump to the leading order.
  void refine_normal(const WheelObstacle& obstacle, const SceneState& at, double step,
                     BodyContact& contact) const {
    const BodyContact::Side body = contact.side;
    const Mechanism& mechanism = assembly_.items[body.item];
    const State& state = at.items[body.item];
    const State middle = middle_of_step(state, step);
    const Vector3 found = state.position + mechanism.point(body, state);
    const Vector3 moved = middle.position - state.position;
    const WheelObstacle::Plane plane =
        obstacle.between(guess_of(contact, at), [&](const Vector3& normal) -> Vector3 {
          return middle.position +
                 mechanism.point(side_at(middle, body, found + moved, -normal), middle);
        });
    contact.side = side_at(state, body, found, -plane.normal);
    contact.side.outwards = -plane.normal;
    contact.normal = plane.normal;
    contact.offset = plane.offset;
  }

  /// A wheel that turns its side to a face meets it with the rim of that side.
  /// @returns false when it does not
  bool add_side(const WheelObstacle& obstacle, const BodyContact& contact, const State& state,
                std::vector<BodyContact>& contacts) const {
    const BodyContact::Side& at = contact.side;
    const auto i = static_cast<std::size_t>(at.caster);
    const CasterDynamics& caster = assembly_.items[at.item].casters[i];
    const double angle = state.casters[i].swivel_angle;
    const Vector3 across = caster.across(state.pose(), angle, -contact.normal);
    if (!CasterDynamics::lies(Vector3(0, 0, across.y()))) return false;
    const std::size_t before = contacts.size();
    for (const Vector3& point : caster.rim(across.y() > 0)) {
      const Vector3 here = state.position + caster.point(state.pose(), angle, point);
      if (!obstacle.faces(contact.normal, here)) continue;
      BodyContact& added = contacts.emplace_back(contact);
      added.side = {at.item, at.caster, point};
    }
    return contacts.size() > before;
  }

  void collect(const btPersistentManifold& manifold, const SceneState& state, double step,
               std::vector<BodyContact>& contacts) const {
    const Part& a = *static_cast<const Part*>(manifold.getBody0()->getUserPointer());
    const Part& b = *static_cast<const Part*>(manifold.getBody1()->getUserPointer());
    const bool first = a.body && (!b.body || a.body->item < b.body->item);
    const Part &part = first ? a : b, &other = first ? b : a;
    const BodyContact::Side& body = *part.body;
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold.getContactPoint(k);
      const Vector3 on_a = from_bullet(point.getPositionWorldOnA());
      const Vector3 on_b = from_bullet(point.getPositionWorldOnB());
      const Vector3 &here = first ? on_a : on_b, &there = first ? on_b : on_a;
      BodyContact contact;
      contact.normal = (first ? 1.0 : -1.0) * from_bullet(point.m_normalWorldOnB);
      contact.side = side_at(state.items[body.item], body, here, -contact.normal);
      if (other.body) {
        contact.other = BodyContact::kItem;
        contact.other_side =
            side_at(state.items[other.body->item], *other.body, there, contact.normal);
      } else {
        contact.other = other.other;
        contact.offset = contact.normal.dot(there);
        if (const auto& obstacle = obstacles_[static_cast<std::size_t>(other.other) - 1]) {
          refine_normal(*obstacle, state, step, contact);
          if (add_side(*obstacle, contact, state.items[body.item], contacts)) continue;
        }
      }
      contacts.push_back(contact);
    }
  }

  const Assembly& assembly_;
  std::vector<std::optional<WheelObstacle>> obstacles_;  // as Scene::room; none of columns
  btDefaultCollisionConfiguration configuration_{small_pools()};
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  std::vector<std::unique_ptr<Part>> parts_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
};

WheelSearch::WheelSearch(const Scene& scene, const Assembly& assembly)
    : scene_(scene), assembly_(assembly) {}
WheelSearch::~WheelSearch() = default;

void WheelSearch::collect(const SceneState& state, double step,
                          std::vector<BodyContact>& contacts) {
  if (!world_) world_ = std::make_unique<World>(scene_, assembly_);
  world_->collect(state, step, contacts);
}

}  // namespace gurney
