#pragma once

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <memory>
#include <vector>

#include "engine/solver/mechanism.h"

namespace gurney {

/// One item as Bullet holds it: a btMultiBody whose base is the chassis with its payloads and whose
/// links are, for caster i, the fork (2 i: revolute about the swivel axis, or fixed) and the wheel
/// (2 i + 1: revolute about the axle). Bullet's bodies use principal axes; this class keeps the
/// rotations between. Wheels are spheres, which touch the floor in one point like a disc that stands
/// upright.
///
/// Everything in btMultiBody that would silently change the mechanics is off: sleeping, damping
/// (0.04 by default), the limits of velocity and impulse.
class MultibodyItem {
 public:
  enum Group : int { kFloor = 1, kChassis = 2, kCasters = 4, kRoom = 8 };

  MultibodyItem(const EquipmentModel& model, const Mechanism& mechanism,
                btMultiBodyDynamicsWorld& world);
  ~MultibodyItem();
  MultibodyItem(const MultibodyItem&) = delete;
  MultibodyItem& operator=(const MultibodyItem&) = delete;

  /// Writes pose and velocities of `state` to the bodies, and moves the collision objects there.
  void set(const State& state);

  /// Reads pose and velocities back.
  void get(State& state) const;

  btMultiBody& body() { return *body_; }

 private:
  void add_collider(int link, std::unique_ptr<btCollisionShape> shape, int group, int mask,
                    double friction);

  btMultiBodyDynamicsWorld& world_;
  std::size_t casters_;
  std::vector<bool> swivels_;
  std::vector<double> headings_;
  std::unique_ptr<btMultiBody> body_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
  Quaternion base_axes_;  // from Bullet's principal axes of the base to chassis axes
  btAlignedObjectArray<btQuaternion> scratch_q_;
  btAlignedObjectArray<btVector3> scratch_v_;
};

}  // namespace gurney
