#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
  OdeTrolley(const CrossCheck& check, double time_step, Setup setup)
      : best_(setup == Setup::kBest),
        direct_(setup != Setup::kDefaults),
        wall_(wall_contact(check, time_step)) {
    const EquipmentModel& item = check.scene.items[0].model;
    dInitODE2(0);
    world_ = dWorldCreate();
    space_ = dSimpleSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    floor_ = dCreatePlane(space_, 0, 0, 1, 0);
    if (direct_) {
      dWorldSetCFM(world_, 1e-10);
      dWorldSetERP(world_, 0.2);
    }
    const MassProperties chassis = chassis_with_payloads(item);
    center_ = chassis.center_of_mass;
    chassis_ = body(chassis.mass, center_, chassis.inertia);
    for (const Wall& wall : check.walls)
      walls_.push_back(
          dCreatePlane(nullptr, wall.normal.x(), wall.normal.y(), wall.normal.z(), wall.offset));
    for (const BodyShape& box : item.shape) {
      boxes_.push_back(dCreateBox(nullptr, box.size.x(), box.size.y(), box.size.z()));
      dGeomSetBody(boxes_.back(), chassis_);
      const Vector3 at = box.center - center_;
      dGeomSetOffsetPosition(boxes_.back(), at.x(), at.y(), at.z());
    }
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
    for (const dGeomID geom : walls_) dGeomDestroy(geom);
    for (const dGeomID geom : boxes_) dGeomDestroy(geom);
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
      touch(wheel, load, time_step);
    }
    for (const dGeomID box : boxes_)
      for (const dGeomID wall : walls_) touch_wall(box, wall);
    if (direct_)
      dWorldStep(world_, time_step);
    else
      dWorldQuickStep(world_, time_step);
  }

  Snapshot pose() const {
    const dReal *p = dBodyGetPosition(chassis_), *r = dBodyGetRotation(chassis_);
    Matrix3 rotation;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) rotation(i, j) = r[4 * i + j];
    return snapshot(Vector3(p[0], p[1], p[2]) - rotation * center_, rotation);
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

  void touch(Wheel& wheel, double load, double time_step) {
    dContact contact{};
    if (dCollide(wheel.geom, floor_, 1, &contact.geom, sizeof contact) == 0) return;
    dVector3 axle;
    dJointGetHingeAxis(wheel.axle, axle);
    set_direction(contact, Vector3(axle[0], axle[1], axle[2]).cross(Vector3::UnitZ()).normalized());
    contact.surface.mode = dContactFDir1;
    contact.surface.mu = wheel.caster->tread.kinetic_friction;
    if (direct_) {
      contact.surface.mode |= dContactSoftCFM | dContactSoftERP;
      contact.surface.soft_cfm = 1e-9;
      contact.surface.soft_erp = 0.2;
    }
    if (best_)
      limit_by_load(wheel, load, time_step, contact);
    else
      contact.surface.mode |= dContactApprox1;
    const dJointID joint = dJointCreateContact(world_, contacts_, &contact);
    dJointAttach(joint, dGeomGetBody(contact.geom.g1), dGeomGetBody(contact.geom.g2));
    dJointSetFeedback(joint, &wheel.contact);
  }

  static void set_direction(dContact& contact, const Vector3& direction) {
    for (int i = 0; i < 3; ++i) contact.fdir1[i] = direction[i];
  }

  /// A wheel that slides faster than it gains speed in a step of 1 g: mu N against its slip and
  /// nothing across it; any other: the pyramid of mu N. N is that of the step before.
  static void limit_by_load(const Wheel& wheel, double load, double time_step, dContact& contact) {
    contact.surface.mode |= dContactMu2;
    contact.surface.mu *= load;
    contact.surface.mu2 = contact.surface.mu;
    dVector3 velocity;
    const dReal* const at = contact.geom.pos;
    dBodyGetPointVel(wheel.body, at[0], at[1], at[2], velocity);
    const Vector3 slip(velocity[0], velocity[1], 0);
    if (slip.norm() <= kStandardGravity * time_step) return;
    contact.surface.mu2 = 0;
    set_direction(contact, slip.normalized());
  }

  /// Defaults: rebound by restitution. Best: a linear spring with our numerical stiffness and the
  /// damping that has our restitution e under the whole mass; ODE's manual, section 3.8.2:
  /// ERP = h k / (h k + c), CFM = 1 / (h k + c).
  dSurfaceParameters wall_contact(const CrossCheck& check, double time_step) const {
    const ContactConstants pair = contact_constants(check.scene, "", "");
    dSurfaceParameters surface{};
    surface.mu = pair.friction;
    surface.mode = dContactApprox1;
    if (!direct_) {
      surface.mode |= dContactBounce;
      surface.bounce = pair.restitution;
      surface.bounce_vel = 0.01;
      return surface;
    }
    const double decay = -std::log(pair.restitution);
    const double ratio = decay / std::hypot(std::numbers::pi, decay);
    const double mass = whole_item(check.scene.items[0].model).mass;
    const double spring = time_step * pair.stiffness;
    const double sum = spring + 2 * ratio * std::sqrt(pair.stiffness * mass);
    surface.mode |= dContactSoftCFM | dContactSoftERP;
    surface.soft_erp = spring / sum;
    surface.soft_cfm = 1 / sum;
    return surface;
  }

  void touch_wall(dGeomID box, dGeomID wall) {
    dContact contacts[4]{};
    const int count = dCollide(box, wall, 4, &contacts[0].geom, sizeof contacts[0]);
    for (int i = 0; i < count; ++i) {
      contacts[i].surface = wall_;
      const dJointID joint = dJointCreateContact(world_, contacts_, &contacts[i]);
      dJointAttach(joint, dGeomGetBody(contacts[i].geom.g1), dGeomGetBody(contacts[i].geom.g2));
    }
  }

  bool best_, direct_;
  dSurfaceParameters wall_;
  std::vector<dGeomID> walls_, boxes_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  dGeomID floor_;
  dBodyID chassis_;
  Vector3 center_;
  std::vector<Wheel> wheels_;
};

}  // namespace

Path ode_path(const CrossCheck& check, double time_step, Setup setup) {
  OdeTrolley trolley(check, time_step, setup);
  const long stride = std::lround(check.sampling / time_step);
  const long steps = std::lround(check.duration / time_step);
  Path path{trolley.pose()};
  for (long k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k) * time_step;
    const Vector3 floor =
        (check.floor.velocity_at(t + time_step) - check.floor.velocity_at(t)) / time_step;
    trolley.step(time_step, -check.scene.gravity * Vector3::UnitZ() - floor);
    if ((k + 1) % stride != 0) continue;
    path.push_back(trolley.pose());
    if (path.back().tilt > kOverturned) break;
  }
  return path;
}

}  // namespace gurney::peers
