#include "engine/baselines/stock_multibody.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyMLCPConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>

#include <algorithm>

#include "engine/bullet/convert.h"
#include "engine/bullet/multibody_item.h"

namespace gurney::baselines {
namespace {

constexpr double kUnlimitedTorque = 1e6;  // [N m]
constexpr double kLeastRebound = 0.01;    // as of our impacts (docs/theory/impact.md) [m/s]

class StockMultibody : public StockModel {
 public:
  StockMultibody(const Scene& scene, const Mechanism& mechanism, bool direct)
      : mechanism_(mechanism),
        solver_(direct ? std::unique_ptr<btMultiBodyConstraintSolver>(
                             std::make_unique<btMultiBodyMLCPConstraintSolver>(&dantzig_))
                       : std::make_unique<btMultiBodyConstraintSolver>()),
        world_(&dispatcher_, &broadphase_, solver_.get(), &configuration_),
        floor_shape_(btVector3(0, 0, 1), 0),
        item_(scene.items[0].model, mechanism, world_) {
    floor_.setCollisionShape(&floor_shape_);
    floor_.setFriction(1);  // Bullet multiplies the two: the tread's coefficient is left
    world_.addCollisionObject(&floor_, MultibodyItem::kFloor,
                              MultibodyItem::kChassis | MultibodyItem::kCasters);
    btContactSolverInfo& info = world_.getSolverInfo();
    info.m_numIterations = 50;
    info.m_restitution = 0;
    info.m_linearSlop = 0;
    if (direct) info.m_globalCfm = 1e-9;
    for (std::size_t i = 0; i < mechanism.casters.size(); ++i) {
      const int link = static_cast<int>(2 * i);
      const Caster& c = scene.items[0].model.casters[i];
      const auto add_motor = [&](int at) {
        motors_.push_back(std::make_unique<btMultiBodyJointMotor>(&item_.body(), at, 0, 0));
        world_.addMultiBodyConstraint(motors_.back().get());
        return motors_.back().get();
      };
      axles_.push_back(add_motor(link + 1));
      swivels_.push_back(c.swivels ? add_motor(link) : nullptr);
      resistance_.push_back(c.tread.rolling_friction_length);
      normal_.push_back(mechanism.total_mass * -mechanism.gravity.z() /
                        static_cast<double>(mechanism.casters.size()));
    }
    if (!scene.room.empty()) add_room(scene);
  }

  ~StockMultibody() override {
    for (auto& motor : motors_) world_.removeMultiBodyConstraint(motor.get());
    for (auto& wall : walls_) world_.removeCollisionObject(wall.get());
    world_.removeCollisionObject(&floor_);
  }

  void place(const State& state) override { item_.set(state); }

  const std::vector<double>& normal_forces() const override { return normal_; }

  void step(double duration, const Vector3& gravity, const std::vector<Loads::Row>& rows,
            const State& before, State& after) override {
    world_.setGravity(to_bullet(gravity));
    item_.body().clearForcesAndTorques();
    for (const auto& row : rows) {
      item_.body().addBaseForce(to_bullet(Vector3(row.force * row.direction.head<3>())));
      item_.body().addBaseTorque(to_bullet(Vector3(row.force * row.direction.tail<3>())));
    }
    for (std::size_t i = 0; i < axles_.size(); ++i) {
      const CasterDynamics& caster = mechanism_.casters[i];
      const Eigen::Vector2d& rates = before.velocity.joints[i];
      const int fork = static_cast<int>(2 * i);
      if (caster.swivels())
        item_.body().addJointTorque(fork, -caster.swivel_friction().viscous * rates[0]);
      item_.body().addJointTorque(fork + 1, -caster.axle_friction().viscous * rates[1]);
      const double axle = std::min(caster.axle_limit(false), kUnlimitedTorque);
      axles_[i]->setMaxAppliedImpulse((resistance_[i] * normal_[i] + axle) * duration);
      if (swivels_[i] != nullptr)
        swivels_[i]->setMaxAppliedImpulse(std::min(caster.swivel_limit(), kUnlimitedTorque) *
                                          duration);
    }
    world_.stepSimulation(duration, 0);
    item_.get(after);
    after.time = before.time + duration;
    read_normal_forces(duration);
  }

 private:
  /// Bullet multiplies frictions and restitutions of two bodies: those of the pair are left.
  void add_room(const Scene& scene) {
    world_.getSolverInfo().m_restitutionVelocityThreshold = kLeastRebound;
    btMultiBodyLinkCollider* const chassis = item_.body().getBaseCollider();
    chassis->setRestitution(1);
    world_.removeCollisionObject(chassis);
    world_.addCollisionObject(chassis, MultibodyItem::kChassis,
                              MultibodyItem::kFloor | MultibodyItem::kRoom);
    for (const RoomShape& shape : scene.room) {
      const ContactConstants pair =
          contact_constants(scene, scene.items[0].model.material, shape.material);
      wall_shapes_.push_back(std::make_unique<btBoxShape>(
          to_bullet(Vector3(0.5 * std::get<RoomBox>(shape.shape).size))));
      walls_.push_back(std::make_unique<btCollisionObject>());
      walls_.back()->setCollisionShape(wall_shapes_.back().get());
      walls_.back()->setWorldTransform(
          btTransform(to_bullet(shape.rotation), to_bullet(shape.position)));
      walls_.back()->setFriction(pair.friction / chassis->getFriction());
      walls_.back()->setRestitution(pair.restitution);
      world_.addCollisionObject(walls_.back().get(), MultibodyItem::kRoom, MultibodyItem::kChassis);
    }
  }

  void read_normal_forces(double duration) {
    std::fill(normal_.begin(), normal_.end(), 0.0);
    for (int m = 0; m < dispatcher_.getNumManifolds(); ++m) {
      const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(m);
      const auto* a = btMultiBodyLinkCollider::upcast(manifold->getBody0());
      const auto* b = btMultiBodyLinkCollider::upcast(manifold->getBody1());
      const auto* item = a != nullptr ? a : b;
      if (item == nullptr || item->m_link < 0) continue;
      for (int k = 0; k < manifold->getNumContacts(); ++k)
        normal_[static_cast<std::size_t>(item->m_link / 2)] +=
            manifold->getContactPoint(k).m_appliedImpulse / duration;
    }
  }

  const Mechanism& mechanism_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btDantzigSolver dantzig_;
  std::unique_ptr<btMultiBodyConstraintSolver> solver_;
  btMultiBodyDynamicsWorld world_;
  btStaticPlaneShape floor_shape_;
  btCollisionObject floor_;
  MultibodyItem item_;
  std::vector<std::unique_ptr<btMultiBodyJointMotor>> motors_;
  std::vector<btMultiBodyJointMotor*> axles_, swivels_;
  std::vector<double> resistance_, normal_;
  std::vector<std::unique_ptr<btBoxShape>> wall_shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> walls_;
};

}  // namespace

std::unique_ptr<StockModel> make_stock_multibody(const Scene& scene, const Mechanism& mechanism,
                                                 bool direct) {
  return std::make_unique<StockMultibody>(scene, mechanism, direct);
}

}  // namespace gurney::baselines
