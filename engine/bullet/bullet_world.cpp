#include "engine/bullet/bullet_world.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "engine/bullet/convert.h"
#include "engine/bullet/multibody_item.h"
#include "engine/bullet/room_objects.h"
#include "engine/solver/floor_points.h"
#include "engine/solver/room_points.h"

namespace gurney {
namespace {

/// Bullet reports contacts from this far; nearer than this a pass is always made [m].
constexpr double kContactMargin = 0.02;

double largest_swing(const Mechanism& mechanism) {
  double swing = 0;
  for (const Leg& leg : mechanism.legs) swing = std::max(swing, leg.swing());
  return swing;
}

/// What Bullet's world needs before it can be made.
struct Foundations {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
};

}  // namespace

class BulletWorld::World : private Foundations, public btMultiBodyDynamicsWorld {
 public:
  World(const Scene& scene, const Mechanism& mechanism, bool skip_clear_passes)
      : btMultiBodyDynamicsWorld(&dispatcher, &broadphase, &solver, &configuration),
        mechanism_(mechanism),
        floor_points_(scene, mechanism),
        room_points_(scene, mechanism),
        item_(scene, mechanism, MultibodyItem::Wheels::kCylinders, *this),
        room_(scene.room, *this),
        reach_(mechanism.reach),
        swing_(largest_swing(mechanism)),
        skip_clear_passes_(skip_clear_passes) {
    // Points are reported from the same distance for shapes of every size.
    dispatcher.setDispatcherFlags(
        dispatcher.getDispatcherFlags() &
        ~btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);
    configuration.setConvexConvexMultipointIterations(3, 3);
  }

  void step(double duration, State& state, const Solve& solve) {
    state_ = &state;
    solve_ = &solve;
    speed_ = speed_of(state);
    stepSimulation(duration, 0);
    travelled_ += duration * std::max(speed_, speed_of(state));
  }

  long passes() const { return passes_; }

  void performDiscreteCollisionDetection() override {
    contacts_.clear();
    const double needed = kContactMargin + 2 * step_ * speed_;
    if (skip_clear_passes_ && clearance_ - travelled_ > needed) return;
    item_.set(*state_);
    forget_last_pass();
    btMultiBodyDynamicsWorld::performDiscreteCollisionDetection();
    ++passes_;
    travelled_ = 0;
    clearance_ = measure_clearance();
    floor_points_.collect(*state_, needed, contacts_);
    room_points_.collect(*state_, step_, needed, contacts_);
    collect_contacts();
  }

  void predictUnconstraintMotion(btScalar duration) override { step_ = duration; }
  void createPredictiveContacts(btScalar) override {}
  void calculateSimulationIslands() override {}
  void solveConstraints(btContactSolverInfo& info) override {
    (*solve_)(info.m_timeStep, contacts_);
  }
  void integrateTransforms(btScalar) override {}
  void updateActivationState(btScalar) override {}
  void saveKinematicState(btScalar) override {}
  void applyGravity() override {}
  void clearForces() override {}
  void synchronizeMotionStates() override {}

 private:
  /// A point that turned with a wheel since the last pass is no contact any more, and Bullet's
  /// search would start from the axis it found then: results would depend on which passes are
  /// skipped.
  void forget_last_pass() {
    const auto& objects = getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i)
      getBroadphase()->getOverlappingPairCache()->cleanProxyFromPairs(
          objects[i]->getBroadphaseHandle(), &dispatcher);
  }

  double speed_of(const State& state) const {
    double speed =
        state.velocity.chassis.head<3>().norm() + state.velocity.chassis.tail<3>().norm() * reach_;
    double joints = 0;
    for (const auto& rates : state.velocity.joints)
      joints = std::max(joints, std::abs(rates[0]) + std::abs(rates[1]));
    return speed + joints * swing_;
  }

  /// Least distance between boxes around what may touch, and from the floor.
  double measure_clearance() {
    double clearance = floor_points_.clearance(*state_);
    const auto& objects = getCollisionObjectArray();
    for (int a = 0; a < objects.size(); ++a) {
      const auto* item = btMultiBodyLinkCollider::upcast(objects[a]);
      if (item == nullptr) continue;
      btVector3 low, high;
      item->getCollisionShape()->getAabb(item->getWorldTransform(), low, high);
      for (int b = 0; b < objects.size(); ++b) {
        if (btMultiBodyLinkCollider::upcast(objects[b]) != nullptr) continue;
        btVector3 other_low, other_high;
        objects[b]->getCollisionShape()->getAabb(objects[b]->getWorldTransform(), other_low,
                                                 other_high);
        double distance = 0;
        for (int k = 0; k < 3; ++k)
          distance = std::max({distance, low[k] - other_high[k], other_low[k] - high[k]});
        clearance = std::min(clearance, distance);
      }
    }
    return clearance;
  }

  /// Of wheels against the room, in an order that does not depend on Bullet's memory.
  void collect_contacts() {
    const std::size_t analytic = contacts_.size();
    const Quaternion to_chassis = state_->rotation.conjugate();
    for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
      const btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(m);
      const auto* a = btMultiBodyLinkCollider::upcast(manifold->getBody0());
      const auto* b = btMultiBodyLinkCollider::upcast(manifold->getBody1());
      const btMultiBodyLinkCollider* item = a != nullptr ? a : b;
      if (item == nullptr) continue;
      const btCollisionObject* other = a != nullptr ? manifold->getBody1() : manifold->getBody0();
      for (int k = 0; k < manifold->getNumContacts(); ++k) {
        const btManifoldPoint& point = manifold->getContactPoint(k);
        const Vector3 on_item =
            from_bullet(a != nullptr ? point.getPositionWorldOnA() : point.getPositionWorldOnB());
        const Vector3 normal = (a != nullptr ? 1.0 : -1.0) * from_bullet(point.m_normalWorldOnB);
        BodyContact contact;
        contact.other = other->getUserIndex();
        contact.local = to_chassis * (on_item - state_->position);
        contact.normal = normal;
        contact.offset = normal.dot(on_item) - point.getDistance();
        if (item->m_link >= 0) {
          contact.body = BodyContact::Body::kWheel;
          contact.leg = item->m_link / 2;
          const auto i = static_cast<std::size_t>(contact.leg);
          contact.local = mechanism_.legs[i].on_fork(state_->pose(), state_->legs[i].swivel_angle,
                                                     on_item - state_->position);
        }
        contacts_.push_back(contact);
      }
    }
    const auto order = [](const BodyContact& c) {
      return std::tuple(c.leg, c.other, c.local.x(), c.local.y(), c.local.z());
    };
    std::sort(contacts_.begin() + static_cast<std::ptrdiff_t>(analytic), contacts_.end(),
              [&](const BodyContact& a, const BodyContact& b) { return order(a) < order(b); });
  }

  const Mechanism& mechanism_;
  FloorPoints floor_points_;
  RoomPoints room_points_;
  MultibodyItem item_;
  RoomObjects room_;
  double reach_, swing_;
  bool skip_clear_passes_;
  State* state_ = nullptr;
  const Solve* solve_ = nullptr;
  std::vector<BodyContact> contacts_;
  double step_ = 0, speed_ = 0, travelled_ = 0, clearance_ = 0;
  long passes_ = 0;
};

BulletWorld::BulletWorld(const Scene& scene, const Mechanism& mechanism, bool skip_clear_passes)
    : world_(std::make_unique<World>(scene, mechanism, skip_clear_passes)) {}
BulletWorld::~BulletWorld() = default;

void BulletWorld::step(double duration, State& state, const Solve& solve) {
  world_->step(duration, state, solve);
}

long BulletWorld::collision_passes() const { return world_->passes(); }

}  // namespace gurney
