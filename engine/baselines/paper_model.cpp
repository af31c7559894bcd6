#include "engine/baselines/paper_model.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletDynamics/ConstraintSolver/btHingeConstraint.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "engine/bullet/convert.h"
#include "engine/bullet/principal_axes.h"

namespace gurney::baselines {
namespace {

constexpr double kFloorHalf = 100;  // [m]
constexpr int kFloor = 1, kItem = 2, kJoined = 4;

/// A rigid body whose own axes are the principal axes of a part.
struct Part {
  std::unique_ptr<btCollisionShape> shape;
  std::unique_ptr<btRigidBody> body;
  Quaternion axes = Quaternion::Identity();  ///< from the body's to the part's axes

  Part(double mass, const PrincipalAxes& inertia, std::unique_ptr<btCollisionShape> of,
       double friction)
      : shape(std::move(of)), axes(inertia.rotation) {
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape.get(),
                                                  to_bullet(inertia.moments));
    info.m_friction = friction;
    body = std::make_unique<btRigidBody>(info);
    body->setActivationState(DISABLE_DEACTIVATION);
  }

  void place(const Vector3& position, const Quaternion& rotation, const Vector3& velocity,
             const Vector3& spin) {
    body->setCenterOfMassTransform(
        btTransform(to_bullet(Quaternion(rotation * axes)), to_bullet(position)));
    body->setInterpolationWorldTransform(body->getCenterOfMassTransform());
    body->setLinearVelocity(to_bullet(velocity));
    body->setAngularVelocity(to_bullet(spin));
  }
  Vector3 position() const { return from_bullet(body->getCenterOfMassPosition()); }
  Quaternion rotation() const {
    return from_bullet(body->getCenterOfMassTransform().getRotation()) * axes.conjugate();
  }
  Vector3 velocity() const { return from_bullet(body->getLinearVelocity()); }
  Vector3 spin() const { return from_bullet(body->getAngularVelocity()); }

  /// A frame of the part as its body has it.
  btTransform frame(const Vector3& origin, const Quaternion& turn) const {
    return btTransform(to_bullet(Quaternion(axes.conjugate() * turn)),
                       to_bullet(Vector3(axes.conjugate() * origin)));
  }
};

struct PaperCaster {
  Caster caster;
  Vector3 mount, wheel;  ///< of chassis and fork, from their centres of mass, in their axes
  Part fork, rolling;
  std::unique_ptr<btHingeConstraint> swivel, axle;
};

Part fork_of(const Caster& c) {
  return {c.fork_mass, principal_axes(c.fork_inertia),
          std::make_unique<btBoxShape>(btVector3(0.01, 0.01, 0.01)), 0};
}

Part wheel_of(const Caster& c) {
  return {c.wheel_mass,
          {Quaternion::Identity(),
           {c.wheel_transverse_inertia, c.wheel_axial_inertia, c.wheel_transverse_inertia}},
          std::make_unique<btCapsuleShape>(c.wheel_radius, c.wheel_width),
          c.tread.kinetic_friction};
}

class PaperModel : public StockModel {
 public:
  PaperModel(const EquipmentModel& item, const Mechanism& mechanism, bool direct)
      : solver_(direct ? std::unique_ptr<btSequentialImpulseConstraintSolver>(
                             std::make_unique<btMLCPSolver>(&dantzig_))
                       : std::make_unique<btSequentialImpulseConstraintSolver>()),
        world_(&dispatcher_, &broadphase_, solver_.get(), &configuration_),
        floor_shape_(btVector3(kFloorHalf, kFloorHalf, 1)),
        floor_(0, nullptr, &floor_shape_),
        chassis_(mechanism.chassis.mass, principal_axes(mechanism.chassis.inertia),
                 std::make_unique<btCompoundShape>(), 0.4) {
    btContactSolverInfo& info = world_.getSolverInfo();
    info.m_numIterations = 50;
    info.m_restitution = 0;
    info.m_linearSlop = 0;
    if (direct) info.m_globalCfm = 1e-8;
    floor_.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, -1)));
    floor_.setFriction(1);  // Bullet multiplies the two: the tread's coefficient is left
    world_.addRigidBody(&floor_, kFloor, kItem);
    add_boxes(item, mechanism.chassis.center_of_mass);
    world_.addRigidBody(chassis_.body.get(), kItem, kFloor);
    casters_.reserve(item.casters.size());
    for (const Caster& c : item.casters) add(c, mechanism.chassis.center_of_mass);
    normal_.assign(casters_.size(), mechanism.total_mass * -mechanism.gravity.z() /
                                        static_cast<double>(casters_.size()));
  }

  ~PaperModel() override {
    for (PaperCaster& c : casters_) {
      world_.removeConstraint(c.axle.get());
      world_.removeConstraint(c.swivel.get());
      world_.removeRigidBody(c.rolling.body.get());
      world_.removeRigidBody(c.fork.body.get());
    }
    world_.removeRigidBody(chassis_.body.get());
    world_.removeRigidBody(&floor_);
  }

  void place(const State& state) override {
    const Vector3 v = state.velocity.chassis.head<3>(), w = state.velocity.chassis.tail<3>();
    chassis_.place(state.position, state.rotation, v, w);
    for (std::size_t i = 0; i < casters_.size(); ++i) {
      PaperCaster& c = casters_[i];
      const Vector3 up = state.rotation * Vector3::UnitZ();
      const Quaternion turn =
          state.rotation * Eigen::AngleAxisd(state.casters[i].swivel_angle, Vector3::UnitZ());
      const Vector3 arm = state.rotation * c.mount, mount = state.position + arm;
      const Vector3 spin = w + state.velocity.joints[i][0] * up, speed = v + w.cross(arm);
      const Vector3 fork = turn * c.caster.fork_center_of_mass;
      const Vector3 wheel = turn * wheel_center(c.caster);
      c.fork.place(mount + fork, turn, speed + spin.cross(fork), spin);
      c.rolling.place(mount + wheel,
                      turn * Eigen::AngleAxisd(state.casters[i].axle_angle, Vector3::UnitY()),
                      speed + spin.cross(wheel),
                      spin + state.velocity.joints[i][1] * (turn * Vector3::UnitY()));
    }
  }

  void step(double duration, const Vector3& gravity, const std::vector<Loads::Row>& rows,
            const State& before, State& after) override {
    for (PaperCaster& c : casters_) {
      c.fork.body->setGravity(to_bullet(gravity));
      c.rolling.body->setGravity(to_bullet(gravity));
    }
    chassis_.body->setGravity(to_bullet(gravity));
    for (const Loads::Row& row : rows) {
      chassis_.body->applyCentralForce(to_bullet(Vector3(row.force * row.direction.head<3>())));
      chassis_.body->applyTorque(to_bullet(Vector3(row.force * row.direction.tail<3>())));
    }
    for (std::size_t i = 0; i < casters_.size(); ++i) apply_resistance(i, before);
    world_.stepSimulation(duration, 0);
    read(duration, before, after);
    read_normal_forces(duration);
  }

  const std::vector<double>& normal_forces() const override { return normal_; }

 private:
  static Vector3 wheel_center(const Caster& c) {
    return {-c.trail, 0, -(c.height - c.wheel_radius)};
  }

  void add_boxes(const EquipmentModel& item, const Vector3& center) {
    auto& all = static_cast<btCompoundShape&>(*chassis_.shape);
    for (const BodyShape& box : item.shape) {
      boxes_.push_back(std::make_unique<btBoxShape>(to_bullet(Vector3(0.5 * box.size))));
      all.addChildShape(chassis_.frame(box.center - center, Quaternion::Identity()),
                        boxes_.back().get());
    }
  }

  void add(const Caster& c, const Vector3& center) {
    casters_.push_back({c, c.mount - center, wheel_center(c) - c.fork_center_of_mass, fork_of(c),
                        wheel_of(c), nullptr, nullptr});
    PaperCaster& added = casters_.back();
    const Quaternion none = Quaternion::Identity();
    const Quaternion axle(Eigen::AngleAxisd(-0.5 * std::numbers::pi, Vector3::UnitX()));  // z to y
    added.swivel = std::make_unique<btHingeConstraint>(
        *chassis_.body, *added.fork.body, chassis_.frame(added.mount, none),
        added.fork.frame(-c.fork_center_of_mass, none));
    if (!c.swivels) added.swivel->setLimit(c.heading, c.heading);
    added.axle = std::make_unique<btHingeConstraint>(*added.fork.body, *added.rolling.body,
                                                     added.fork.frame(added.wheel, axle),
                                                     added.rolling.frame(Vector3::Zero(), axle));
    added.rolling.body->setUserIndex(static_cast<int>(casters_.size()) - 1);
    world_.addRigidBody(added.fork.body.get(), kJoined, 0);
    world_.addRigidBody(added.rolling.body.get(), kItem, kFloor);
    world_.addConstraint(added.swivel.get(), true);
    world_.addConstraint(added.axle.get(), true);
  }

  void apply_resistance(std::size_t i, const State& before) {
    PaperCaster& c = casters_[i];
    Vector3 motion = c.rolling.velocity();
    motion.z() = 0;
    if (motion.norm() > 0) {
      const double resistance =
          c.caster.tread.rolling_friction_length / c.caster.wheel_radius * normal_[i];
      c.rolling.body->applyCentralForce(to_bullet(Vector3(-resistance / motion.norm() * motion)));
    }
    const double turned = before.casters[i].swivel_angle - c.caster.heading;
    const Eigen::Vector2d& rates = before.velocity.joints[i];
    const Vector3 swivel =
        (-c.caster.swivel.coulomb * turned - c.caster.swivel.viscous * rates[0]) *
        (chassis_.rotation() * Vector3::UnitZ());
    const Vector3 axle = -c.caster.axle.viscous * rates[1] * (c.fork.rotation() * Vector3::UnitY());
    chassis_.body->applyTorque(to_bullet(Vector3(-swivel)));
    c.fork.body->applyTorque(to_bullet(Vector3(swivel - axle)));
    c.rolling.body->applyTorque(to_bullet(axle));
  }

  void read(double duration, const State& before, State& after) const {
    after.time = before.time + duration;
    after.position = chassis_.position();
    after.rotation = chassis_.rotation().normalized();
    after.velocity.chassis << chassis_.velocity(), chassis_.spin();
    for (std::size_t i = 0; i < casters_.size(); ++i) {
      const PaperCaster& c = casters_[i];
      const Matrix3 fork = (after.rotation.conjugate() * c.fork.rotation()).toRotationMatrix();
      const double angle = std::atan2(fork(1, 0), fork(0, 0)),
                   last = before.casters[i].swivel_angle;
      after.casters[i].swivel_angle = last + std::remainder(angle - last, 2 * std::numbers::pi);
      const Vector3 up = after.rotation * Vector3::UnitZ();
      const Vector3 across = c.fork.rotation() * Vector3::UnitY();
      after.velocity.joints[i] = {up.dot(c.fork.spin() - chassis_.spin()),
                                  across.dot(c.rolling.spin() - c.fork.spin())};
      after.casters[i].axle_angle =
          before.casters[i].axle_angle + duration * after.velocity.joints[i][1];
    }
  }

  void read_normal_forces(double duration) {
    std::fill(normal_.begin(), normal_.end(), 0.0);
    for (int m = 0; m < dispatcher_.getNumManifolds(); ++m) {
      const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(m);
      const int wheel =
          std::max(manifold->getBody0()->getUserIndex(), manifold->getBody1()->getUserIndex());
      if (wheel < 0) continue;
      for (int k = 0; k < manifold->getNumContacts(); ++k) {
        const btManifoldPoint& point = manifold->getContactPoint(k);
        normal_[static_cast<std::size_t>(wheel)] +=
            point.m_appliedImpulse * std::abs(point.m_normalWorldOnB.z()) / duration;
      }
    }
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btDantzigSolver dantzig_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> solver_;
  btDiscreteDynamicsWorld world_;
  btBoxShape floor_shape_;
  btRigidBody floor_;
  std::vector<std::unique_ptr<btBoxShape>> boxes_;
  Part chassis_;
  std::vector<PaperCaster> casters_;
  std::vector<double> normal_;
};

}  // namespace

std::unique_ptr<StockModel> make_paper_model(const Scene& scene, const Mechanism& mechanism,
                                             bool direct) {
  const EquipmentModel& item = scene.items[0].model;
  for (const Caster& c : item.casters)
    require(c.brake_torque == 0 && c.swivel_lock_torque == 0,
            "caster '" + c.name +
                "': the model of the paper (solver = \"bullet-paper\") has no brakes and no swivel "
                "locks; use solver = \"implicit\" for this job");
  return std::make_unique<PaperModel>(item, mechanism, direct);
}

}  // namespace gurney::baselines
