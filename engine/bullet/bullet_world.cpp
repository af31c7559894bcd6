#include "engine/bullet/bullet_world.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <LinearMath/btAlignedAllocator.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <optional>
#include <tuple>

#include "engine/bullet/convert.h"
#include "engine/bullet/multibody_item.h"
#include "engine/bullet/room_objects.h"
#include "engine/contact/wheel_obstacle.h"
#include "engine/solver/chassis_points.h"
#include "engine/solver/floor_points.h"
#include "engine/solver/placed_shape.h"
#include "engine/solver/wheel_clearance.h"

namespace gurney {
namespace {

void* allocate(std::size_t size) {
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

/// Bullet does not look at what its allocator returns: without memory it would write through null.
const bool kAllocatorIsSet = (btAlignedAllocSetCustom(allocate, std::free), true);

/// Bullet reports contacts from this far, its gContactBreakingThreshold [m].
constexpr double kContactMargin = 0.02;

/// A pass is made for wheels nearer than this: the distance that Bullet finds of smooth bodies is off
/// by far less than 1 mm.
constexpr double kWheelRange = kContactMargin + 1e-3;

constexpr double kMaxParts = 100;  // of a step, each with a pass of its own

/// How fast any point of the item moves at most, with a share of its wheels' spin.
double speed_of(const Mechanism& mechanism, const State& state, double spin = 1) {
  double swing = 0, joints = 0;
  for (std::size_t i = 0; i < mechanism.casters.size(); ++i) {
    const auto& rates = state.velocity.joints[i];
    swing = std::max(swing, mechanism.casters[i].swing());
    joints = std::max(joints, std::abs(rates[0]) + spin * std::abs(rates[1]));
  }
  return state.velocity.chassis.head<3>().norm() +
         state.velocity.chassis.tail<3>().norm() * mechanism.reach + joints * swing;
}

/// How fast any part of the item sweeps through space at most: a wheel's spin does not count.
double sweep_of(const Mechanism& mechanism, const State& state) {
  return speed_of(mechanism, state, 0);
}

/// Pools for the pairs of a room; for more, Bullet allocates one by one. Its own are for 4096
/// pairs: megabytes that every run would write.
btDefaultCollisionConstructionInfo small_pools() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = info.m_defaultMaxCollisionAlgorithmPoolSize = 128;
  return info;
}

/// What Bullet's world needs before it can be made.
struct BulletComponents {
  btDefaultCollisionConfiguration configuration{small_pools()};
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
};

}  // namespace

class BulletWorld::World : private BulletComponents, public btMultiBodyDynamicsWorld {
 public:
  World(const Scene& scene, const Assembly& assembly, bool skip_clear_passes)
      : btMultiBodyDynamicsWorld(&dispatcher, &broadphase, &solver, &configuration),
        assembly_(assembly),
        travels_(assembly, skip_clear_passes),
        chassis_points_(scene, assembly),
        wheel_clearance_(scene, assembly),
        room_(scene.room, *this),
        skip_clear_passes_(skip_clear_passes) {
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
      const EquipmentModel& model = scene.items[i].model;
      floor_points_.emplace_back(model, assembly.items[i], i);
      items_.push_back(std::make_unique<MultibodyItem>(
          model, assembly.items[i], static_cast<int>(i), MultibodyItem::Wheels::kCylinders, *this));
    }
    for (const RoomShape& shape : scene.room) {
      const auto placed = placed_shape(shape);
      const auto* polyhedron = std::get_if<ConvexShape>(&placed);
      obstacles_.push_back(polyhedron ? std::optional<WheelObstacle>(*polyhedron) : std::nullopt);
    }
    // Points are reported from the same distance for shapes of every size.
    dispatcher.setDispatcherFlags(
        dispatcher.getDispatcherFlags() &
        ~btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);
  }

  bool step(double from, double until, SceneState& state, const Solve& solve) {
    state_ = &state;
    solve_ = &solve;
    solved_ = true;
    for (double time = from; solved_ && time < until; time = stop_) {
      stop_ = next_pass(time, until);
      speed_ = approach_speed();
      stepSimulation(stop_ - time, 0);
    }
    return solved_;
  }

  long passes() const { return passes_; }

  void performDiscreteCollisionDetection() override {
    contacts_.clear();
    travels_.observe(*state_);
    const double needed = kContactMargin + 2 * step_ * speed_;
    for (std::size_t i = 0; i < items_.size(); ++i)
      floor_points_[i].collect(state_->items[i], travels_.of(i), needed, contacts_);
    chassis_points_.collect(*state_, travels_, step_, needed, contacts_);
    if (skip_clear_passes_ && !wheel_clearance_.any_near(*state_, travels_, kWheelRange)) return;
    for (std::size_t i = 0; i < items_.size(); ++i) items_[i]->set(state_->items[i]);
    clear_cached_manifolds();
    btMultiBodyDynamicsWorld::performDiscreteCollisionDetection();
    ++passes_;
    collect_contacts();
  }

  void predictUnconstraintMotion(btScalar duration) override { step_ = duration; }
  void createPredictiveContacts(btScalar) override {}
  void calculateSimulationIslands() override {}
  void solveConstraints(btContactSolverInfo&) override { solved_ = (*solve_)(stop_, contacts_); }
  void integrateTransforms(btScalar) override {}
  void updateActivationState(btScalar) override {}
  void saveKinematicState(btScalar) override {}
  void applyGravity() override {}
  void clearForces() override {}
  void synchronizeMotionStates() override {}

 private:
  /// Nothing may travel past the margin between two passes: it would be found inside another body.
  double next_pass(double time, double until) const {
    if (obstacles_.empty() && items_.size() == 1) return until;
    double fastest = 0;
    for (std::size_t i = 0; i < items_.size(); ++i)
      fastest = std::max(fastest, sweep_of(assembly_.items[i], state_->items[i]));
    const double remaining = until - time;
    const double parts = std::min(std::ceil(remaining * fastest / kContactMargin), kMaxParts);
    return parts < 2 ? until : time + remaining / parts;
  }

  /// A point that turned with a wheel since the last pass is no contact any more, and Bullet's
  /// search would start from the axis it found then: results would depend on which passes are
  /// skipped.
  void clear_cached_manifolds() {
    btOverlappingPairCache& cache = *getBroadphase()->getOverlappingPairCache();
    for (int i = 0; i < cache.getNumOverlappingPairs(); ++i)
      cache.cleanOverlappingPair(cache.getOverlappingPairArray()[i], &dispatcher);
  }

  /// How fast two things get nearer to each other at most.
  double approach_speed() const {
    double fastest = 0, second = 0;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const double speed = speed_of(assembly_.items[i], state_->items[i]);
      second = std::max(second, std::min(speed, fastest));
      fastest = std::max(fastest, speed);
    }
    return fastest + second;
  }

  /// @param towards  unit, outwards of the body
  BodyContact::Side side_at(const State& state, const btMultiBodyLinkCollider& body,
                            const Vector3& point, const Vector3& towards) const {
    const auto item = static_cast<std::size_t>(body.getUserIndex());
    if (body.m_link < 0) return {item, -1, state.rotation.conjugate() * (point - state.position)};
    const int caster = body.m_link / 2;
    const auto i = static_cast<std::size_t>(caster);
    const CasterDynamics& wheel = assembly_.items[item].casters[i];
    const Pose pose = state.pose();
    const double angle = state.casters[i].swivel_angle;
    const Vector3 origin = wheel.point(pose, angle, Vector3::Zero());
    const Vector3 direction = wheel.on_fork(pose, angle, origin + towards);
    return {item, caster,
            wheel.tread_point(direction, wheel.on_fork(pose, angle, point - state.position))};
  }

  BodyContact::Side side_now(const btMultiBodyLinkCollider& body, const Vector3& point,
                             const Vector3& towards) const {
    return side_at(state_->items[static_cast<std::size_t>(body.getUserIndex())], body, point,
                   towards);
  }

  /// Bullet's normal of a tread before a polyhedron is a guess; of one that touches, the normal it
  /// had is a better one: of a deep overlap Bullet may separate it through another face.
  Vector3 guess_of(const BodyContact& contact) const {
    for (const BodyContactState& memory : state_->contacts)
      if (memory.compression > 0 && memory.contact.same_pair(contact)) return memory.contact.normal;
    return contact.normal;
  }

  /// An item in the middle of the step that begins.
  State in_middle_of_step(const State& start) const {
    const double time = 0.5 * step_;
    State state = start;
    state.position += time * start.velocity.chassis.head<3>();
    state.rotation = rotated(time * start.velocity.chassis.tail<3>(), start.rotation);
    for (std::size_t i = 0; i < state.casters.size(); ++i)
      state.casters[i].swivel_angle += time * start.velocity.joints[i][0];
    return state;
  }

  /// A tread before a polyhedron. The plane stays for the step: that of its middle errs alike at
  /// both ends, so that the next one takes over without a jump to the leading order.
  void refine_normal(const btMultiBodyLinkCollider& body, BodyContact& contact) const {
    const auto& obstacle = obstacles_[static_cast<std::size_t>(contact.other) - 1];
    if (!obstacle || body.m_link < 0) return;
    const Mechanism& mechanism = assembly_.items[contact.side.item];
    const State& state = state_->items[contact.side.item];
    const State middle = in_middle_of_step(state);
    const Vector3 found = state.position + mechanism.point(contact.side, state);
    const Vector3 moved = middle.position - state.position;
    const WheelObstacle::Plane plane =
        obstacle->between(guess_of(contact), [&](const Vector3& normal) -> Vector3 {
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
  bool add_side(const BodyContact& contact) {
    const BodyContact::Side& at = contact.side;
    const auto& obstacle = obstacles_[static_cast<std::size_t>(contact.other) - 1];
    if (!obstacle || at.caster < 0) return false;
    const auto i = static_cast<std::size_t>(at.caster);
    const CasterDynamics& caster = assembly_.items[at.item].casters[i];
    const State& state = state_->items[at.item];
    const double angle = state.casters[i].swivel_angle;
    const Vector3 across = caster.across(state.pose(), angle, -contact.normal);
    if (!CasterDynamics::lies(Vector3(0, 0, across.y()))) return false;
    const std::size_t before = contacts_.size();
    for (const Vector3& point : caster.rim(across.y() > 0)) {
      const Vector3 here = state.position + caster.point(state.pose(), angle, point);
      if (!obstacle->faces(contact.normal, here)) continue;
      BodyContact& added = contacts_.emplace_back(contact);
      added.side = {at.item, at.caster, point};
    }
    return contacts_.size() > before;
  }

  /// Of wheels against the room and other items.
  void collect_contacts() {
    for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
      const btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(m);
      const auto* a = btMultiBodyLinkCollider::upcast(manifold->getBody0());
      const auto* b = btMultiBodyLinkCollider::upcast(manifold->getBody1());
      const bool first = a != nullptr && (b == nullptr || a->getUserIndex() < b->getUserIndex());
      const btMultiBodyLinkCollider* body = first ? a : b;
      const btMultiBodyLinkCollider* other_body = first ? b : a;
      if (body == nullptr) continue;
      const btCollisionObject* other = first ? manifold->getBody1() : manifold->getBody0();
      for (int k = 0; k < manifold->getNumContacts(); ++k) {
        const btManifoldPoint& point = manifold->getContactPoint(k);
        const Vector3 on_a = from_bullet(point.getPositionWorldOnA());
        const Vector3 on_b = from_bullet(point.getPositionWorldOnB());
        BodyContact contact;
        contact.normal = (first ? 1.0 : -1.0) * from_bullet(point.m_normalWorldOnB);
        contact.side = side_now(*body, first ? on_a : on_b, -contact.normal);
        if (other_body != nullptr) {
          contact.other = BodyContact::kItem;
          contact.other_side = side_now(*other_body, first ? on_b : on_a, contact.normal);
        } else {
          contact.other = other->getUserIndex();
          contact.offset = contact.normal.dot(first ? on_b : on_a);
          refine_normal(*body, contact);
          if (add_side(contact)) continue;
        }
        contacts_.push_back(contact);
      }
    }
  }

  const Assembly& assembly_;
  Travels travels_;
  ChassisPoints chassis_points_;
  std::vector<FloorPoints> floor_points_;
  WheelClearance wheel_clearance_;
  std::vector<std::optional<WheelObstacle>> obstacles_;  // as Scene::room; none of columns
  std::vector<std::unique_ptr<MultibodyItem>> items_;
  RoomObjects room_;
  bool skip_clear_passes_;
  SceneState* state_ = nullptr;
  bool solved_ = true;
  double stop_ = 0;  // of the step that is made
  const Solve* solve_ = nullptr;
  std::vector<BodyContact> contacts_;
  double step_ = 0, speed_ = 0;
  long passes_ = 0;
};

BulletWorld::BulletWorld(const Scene& scene, const Assembly& assembly, bool skip_clear_passes)
    : world_(std::make_unique<World>(scene, assembly, skip_clear_passes)) {}
BulletWorld::~BulletWorld() = default;

bool BulletWorld::step(double from, double until, SceneState& state, const Solve& solve) {
  return world_->step(from, until, state, solve);
}

long BulletWorld::collision_passes() const { return world_->passes(); }

}  // namespace gurney
