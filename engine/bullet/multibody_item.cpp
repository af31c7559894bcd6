#include "engine/bullet/multibody_item.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include "engine/bullet/convert.h"
#include "engine/bullet/principal_axes.h"

namespace gurney {
namespace {

constexpr double kUnlimited = 1e30;

int fork_link(std::size_t caster) { return static_cast<int>(2 * caster); }
int wheel_link(std::size_t caster) { return static_cast<int>(2 * caster) + 1; }

}  // namespace

MultibodyItem::MultibodyItem(const EquipmentModel& model, const Mechanism& mechanism,
                             btMultiBodyDynamicsWorld& world)
    : world_(world), casters_(model.casters.size()) {
  const MassProperties& chassis = mechanism.chassis;
  const PrincipalAxes base = principal_axes(chassis.inertia);
  base_axes_ = base.rotation;
  body_ = std::make_unique<btMultiBody>(static_cast<int>(2 * casters_), chassis.mass,
                                        to_bullet(base.moments), false, false);
  body_->setLinearDamping(0);
  body_->setAngularDamping(0);
  body_->setUseGyroTerm(true);
  body_->setMaxCoordinateVelocity(kUnlimited);
  body_->setMaxAppliedImpulse(kUnlimited);
  body_->setHasSelfCollision(false);

  for (std::size_t i = 0; i < casters_; ++i) {
    const Caster& c = model.casters[i];
    swivels_.push_back(c.swivels);
    headings_.push_back(c.heading);
    const PrincipalAxes fork = principal_axes(c.fork_inertia);
    const Vector3 mount = base_axes_.conjugate() * (c.mount - chassis.center_of_mass);
    const Vector3 fork_com = fork.rotation.conjugate() * c.fork_center_of_mass;
    if (c.swivels) {
      const Quaternion to_fork = fork.rotation.conjugate() * base_axes_;
      body_->setupRevolute(fork_link(i), c.fork_mass, to_bullet(fork.moments), -1,
                           to_bullet(to_fork),
                           to_bullet(Vector3(fork.rotation.conjugate() * Vector3::UnitZ())),
                           to_bullet(mount), to_bullet(fork_com), true);
    } else {
      const Quaternion turn(Eigen::AngleAxisd(-c.heading, Vector3::UnitZ()));
      const Quaternion to_fork = fork.rotation.conjugate() * turn * base_axes_;
      body_->setupFixed(fork_link(i), c.fork_mass, to_bullet(fork.moments), -1, to_bullet(to_fork),
                        to_bullet(mount), to_bullet(fork_com));
    }
    const Vector3 wheel_center(-c.trail, 0, -(c.height - c.wheel_radius));
    const Vector3 to_wheel = fork.rotation.conjugate() * (wheel_center - c.fork_center_of_mass);
    const double t = c.wheel_transverse_inertia;
    body_->setupRevolute(wheel_link(i), c.wheel_mass, btVector3(t, c.wheel_axial_inertia, t),
                         fork_link(i), to_bullet(fork.rotation), btVector3(0, 1, 0),
                         to_bullet(to_wheel), btVector3(0, 0, 0), true);
  }
  body_->finalizeMultiDof();
  world_.addMultiBody(body_.get());

  auto boxes = std::make_unique<btCompoundShape>();
  for (const BodyShape& box : model.shape) {
    auto shape = std::make_unique<btBoxShape>(to_bullet(Vector3(0.5 * box.size)));
    shape->setMargin(0.001);
    shape->initializePolyhedralFeatures();  // whole faces of contact with boxes of the room
    shapes_.push_back(std::move(shape));
    const Vector3 center = base_axes_.conjugate() * (box.center - chassis.center_of_mass);
    boxes->addChildShape(
        btTransform(to_bullet(Quaternion(base_axes_.conjugate())), to_bullet(center)),
        shapes_.back().get());
  }
  add_collider(-1, std::move(boxes), kChassis, kFloor | kCasters, 0.4);
  for (std::size_t i = 0; i < casters_; ++i) {
    const Caster& c = model.casters[i];
    add_collider(wheel_link(i), std::make_unique<btSphereShape>(c.wheel_radius), kCasters,
                 kFloor | kRoom, c.tread.kinetic_friction);
  }
}

MultibodyItem::~MultibodyItem() {
  for (auto& collider : colliders_) world_.removeCollisionObject(collider.get());
  world_.removeMultiBody(body_.get());
}

void MultibodyItem::add_collider(int link, std::unique_ptr<btCollisionShape> shape, int group,
                                 int mask, double friction) {
  auto collider = std::make_unique<btMultiBodyLinkCollider>(body_.get(), link);
  collider->setCollisionShape(shape.get());
  collider->setFriction(friction);
  collider->setRollingFriction(0);
  collider->setSpinningFriction(0);
  collider->setRestitution(0);
  collider->setActivationState(DISABLE_DEACTIVATION);
  world_.addCollisionObject(collider.get(), group, mask);
  if (link < 0) {
    body_->setBaseCollider(collider.get());
  } else {
    body_->getLink(link).m_collider = collider.get();
  }
  shapes_.push_back(std::move(shape));
  colliders_.push_back(std::move(collider));
}

void MultibodyItem::set(const State& state) {
  const Quaternion rotation = state.rotation * base_axes_;
  body_->setBasePos(to_bullet(state.position));
  body_->setWorldToBaseRot(to_bullet(Quaternion(rotation.conjugate())));
  body_->setBaseVel(to_bullet(Vector3(state.velocity.chassis.head<3>())));
  body_->setBaseOmega(to_bullet(Vector3(state.velocity.chassis.tail<3>())));
  for (std::size_t i = 0; i < casters_; ++i) {
    if (swivels_[i]) {
      body_->setJointPos(fork_link(i), state.casters[i].swivel_angle);
      body_->setJointVel(fork_link(i), state.velocity.joints[i][0]);
    }
    body_->setJointPos(wheel_link(i), state.casters[i].axle_angle);
    body_->setJointVel(wheel_link(i), state.velocity.joints[i][1]);
  }
  body_->forwardKinematics(scratch_q_, scratch_v_);
  body_->updateCollisionObjectWorldTransforms(scratch_q_, scratch_v_);
}

void MultibodyItem::get(State& state) const {
  state.position = from_bullet(body_->getBasePos());
  const Quaternion rotation = from_bullet(body_->getWorldToBaseRot()).conjugate();
  state.rotation = (rotation * base_axes_.conjugate()).normalized();
  state.velocity.chassis << from_bullet(body_->getBaseVel()), from_bullet(body_->getBaseOmega());
  for (std::size_t i = 0; i < casters_; ++i) {
    state.casters[i].swivel_angle = swivels_[i] ? body_->getJointPos(fork_link(i)) : headings_[i];
    state.velocity.joints[i][0] = swivels_[i] ? body_->getJointVel(fork_link(i)) : 0;
    state.casters[i].axle_angle = body_->getJointPos(wheel_link(i));
    state.velocity.joints[i][1] = body_->getJointVel(wheel_link(i));
  }
}

}  // namespace gurney
