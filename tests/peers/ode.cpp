#include <ode/ode.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "tests/peers/cross_check.h"

static_assert(sizeof(dReal) == sizeof(double));

namespace gurney::peers {
namespace {

struct Wheel {
  dBodyID fork, body;
  dGeomID geom;
  dJointID axle;
  dJointFeedback contact;
  const Caster* caster;
};

/// The world of one run.
class OdeTrolley {
 public:
  explicit OdeTrolley(const EquipmentModel& item) {
    dInitODE2(0);
    world_ = dWorldCreate();
    space_ = dSimpleSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    floor_ = dCreatePlane(space_, 0, 0, 1, 0);
    dWorldSetCFM(world_, 1e-10);
    dWorldSetERP(world_, 0.2);
    const MassProperties chassis = chassis_with_payloads(item);
    center_ = chassis.center_of_mass;
    chassis_ = body(chassis.mass, center_, chassis.inertia);
    const double share = whole_item(item).mass / static_cast<double>(item.casters.size());
    for (const Caster& c : item.casters) {
      Wheel wheel{};
      wheel.caster = &c;
      wheel.contact.f1[2] = share * kStandardGravity;  // the guess of the first step
      const Matrix3 turn = Eigen::AngleAxisd(c.heading, Vector3::UnitZ()).toRotationMatrix();
      const Vector3 center = c.mount + turn * Vector3(-c.trail, 0, c.wheel_radius - c.height);
      const Matrix3 inertia =
          Vector3(c.wheel_transverse_inertia, c.wheel_axial_inertia, c.wheel_transverse_inertia)
              .asDiagonal();
      wheel.fork = body(c.fork_mass, c.mount + turn * c.fork_center_of_mass,
                        turn * c.fork_inertia * turn.transpose());
      wheel.body = body(c.wheel_mass, center, turn * inertia * turn.transpose());
      wheel.geom = dCreateSphere(space_, c.wheel_radius);
      dGeomSetBody(wheel.geom, wheel.body);
      const dJointID swivel = hinge(wheel.fork, chassis_, c.mount, Vector3::UnitZ());
      dJointSetHingeParam(swivel, dParamVel, 0);
      dJointSetHingeParam(swivel, dParamFMax, swivel_friction(c));
      wheel.axle = hinge(wheel.body, wheel.fork, center, turn * Vector3::UnitY());
      dJointSetHingeParam(wheel.axle, dParamVel, 0);
      wheels_.push_back(wheel);
    }
  }
  OdeTrolley(const OdeTrolley&) = delete;
  OdeTrolley& operator=(const OdeTrolley&) = delete;
  ~OdeTrolley() {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
    dCloseODE();
  }

  void step(double time_step, const Vector3& gravity) {
    dWorldSetGravity(world_, gravity.x(), gravity.y(), gravity.z());
    dJointGroupEmpty(contacts_);
    for (Wheel& wheel : wheels_) {
      const double load = std::max(wheel.contact.f1[2], 0.0);
      dJointSetHingeParam(wheel.axle, dParamFMax, axle_friction(*wheel.caster, load));
      wheel.contact.f1[2] = 0;
      touch(wheel);
    }
    dWorldStep(world_, time_step);
  }

  Vector3 pose() const {
    const dReal *p = dBodyGetPosition(chassis_), *r = dBodyGetRotation(chassis_);
    Matrix3 rotation;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) rotation(i, j) = r[4 * i + j];
    const Vector3 origin = Vector3(p[0], p[1], p[2]) - rotation * center_;
    return {origin.x(), origin.y(), std::atan2(rotation(1, 0), rotation(0, 0))};
  }

 private:
  dBodyID body(double mass, const Vector3& center, const Matrix3& inertia) {
    const dBodyID body = dBodyCreate(world_);
    dMass m;
    dMassSetParameters(&m, mass, 0, 0, 0, inertia(0, 0), inertia(1, 1), inertia(2, 2),
                       inertia(0, 1), inertia(0, 2), inertia(1, 2));
    dBodySetMass(body, &m);
    dBodySetPosition(body, center.x(), center.y(), center.z());
    dBodySetGyroscopicMode(body, 1);
    return body;
  }

  dJointID hinge(dBodyID one, dBodyID two, const Vector3& anchor, const Vector3& axis) {
    const dJointID joint = dJointCreateHinge(world_, nullptr);
    dJointAttach(joint, one, two);
    dJointSetHingeAnchor(joint, anchor.x(), anchor.y(), anchor.z());
    dJointSetHingeAxis(joint, axis.x(), axis.y(), axis.z());
    return joint;
  }

  void touch(Wheel& wheel) {
    dContact contact{};
    if (dCollide(wheel.geom, floor_, 1, &contact.geom, sizeof contact) == 0) return;
    dVector3 axle;
    dJointGetHingeAxis(wheel.axle, axle);
    const Vector3 rolls = Vector3(axle[0], axle[1], axle[2]).cross(Vector3::UnitZ()).normalized();
    contact.surface.mode = dContactApprox1 | dContactFDir1 | dContactSoftCFM | dContactSoftERP;
    contact.surface.mu = wheel.caster->tread.kinetic_friction;
    contact.surface.soft_cfm = 1e-9;
    contact.surface.soft_erp = 0.2;
    for (int i = 0; i < 3; ++i) contact.fdir1[i] = rolls[i];
    const dJointID joint = dJointCreateContact(world_, contacts_, &contact);
    dJointAttach(joint, dGeomGetBody(contact.geom.g1), dGeomGetBody(contact.geom.g2));
    dJointSetFeedback(joint, &wheel.contact);
  }

  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  dGeomID floor_;
  dBodyID chassis_;
  Vector3 center_;
  std::vector<Wheel> wheels_;
};

}  // namespace

Path ode_path(const CrossCheck& check, double time_step) {
  OdeTrolley trolley(check.scene.items[0].model);
  const long stride = std::lround(check.sampling / time_step);
  const long steps = std::lround(check.duration / time_step);
  Path path{trolley.pose()};
  for (long k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k) * time_step;
    const Vector3 floor =
        (check.floor.velocity_at(t + time_step) - check.floor.velocity_at(t)) / time_step;
    trolley.step(time_step, -check.scene.gravity * Vector3::UnitZ() - floor);
    if ((k + 1) % stride == 0) path.push_back(trolley.pose());
  }
  return path;
}

}  // namespace gurney::peers
