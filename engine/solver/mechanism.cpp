#include "engine/solver/mechanism.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace gurney {
Vector3 point_of(const CasterDynamics& caster, const Pose& pose, double swivel_angle,
                 const BodyContact::Side& side) {
  return side.outwards.isZero() ? caster.point(pose, swivel_angle, side.local)
                                : caster.tread_point(pose, swivel_angle, side.outwards, side.local);
}

Vector3 gravity_on_slope(double gravity, double slope, double cross_slope) {
  const double steepest = std::hypot(slope, cross_slope);
  if (steepest == 0) return {0, 0, -gravity};
  const double angle = std::atan(steepest), along = -gravity * std::sin(angle);
  return {along * (slope / steepest), along * (cross_slope / steepest), -gravity * std::cos(angle)};
}

Mechanism::Mechanism(const Scene& scene, std::size_t item)
    : chassis(chassis_with_payloads(scene.items[item].model)),
      loads(scene.items[item], chassis.center_of_mass, scene.gravity),
      tethers(scene, item, chassis.center_of_mass),
      fixture(scene.items[item].fixture),
      gravity(gravity_on_slope(scene.gravity, scene.slope, scene.cross_slope)),
      total_mass(chassis.mass),
      length(0),
      reach(0) {
  const EquipmentModel& model = scene.items[item].model;
  for (const auto& caster : model.casters) {
    casters.emplace_back(caster, chassis.center_of_mass);
    total_mass += casters.back().mass();
    length =
        std::max({length, (caster.mount - chassis.center_of_mass).norm(), caster.wheel_radius});
    reach = std::max(reach, casters.back().reach());
  }
  for (const BodyShape& shape : model.shape) {
    surfaces.push_back(round_surface(shape, chassis.center_of_mass));
    reach = std::max(reach, reach_from(shape, chassis.center_of_mass));
    if (casters.empty()) length = std::max(length, 0.5 * shape.size.norm());
  }
}

Vector3 Mechanism::point(const BodyContact::Side& side, const State& state) const {
  if (side.caster < 0 && side.round < 0) return state.rotation * side.local;
  if (side.caster < 0) return chassis_point(side, state.rotation.toRotationMatrix());
  const auto caster = static_cast<std::size_t>(side.caster);
  return point_of(casters[caster], state.pose(), state.casters[caster].swivel_angle, side);
}

Vector3 Mechanism::velocity(const BodyContact::Side& side, const State& state) const {
  const Vector6& v = state.velocity.chassis;
  const Vector3 here = point(side, state);
  const Vector3 u = v.head<3>() + v.tail<3>().cross(here);
  if (side.caster < 0) return u;
  const auto caster = static_cast<std::size_t>(side.caster);
  if (!casters[caster].swivels()) return u;
  const auto g = casters[caster].contact(state.pose(), state.casters[caster].swivel_angle);
  return u +
         state.velocity.joints[caster][0] * lane(g.swivel_axis, 0).cross(here - lane(g.mount, 0));
}

double Mechanism::mobility(const BodyContact::Side& side, const Vector3& normal,
                           const State& state) const {
  Vector6 direction;
  direction << normal, point(side, state).cross(normal);
  return mobility(direction, state);
}

double Mechanism::mobility(const Vector6& direction, const State& state) const {
  const Vector3 moment = state.rotation.conjugate() * direction.tail<3>();
  return direction.head<3>().squaredNorm() / chassis.mass +
         moment.dot(chassis.inertia.inverse() * moment);
}

State Mechanism::placed(const InitialMotion& initial) const {
  State state;
  state.rotation = Quaternion(Eigen::AngleAxisd(initial.yaw, Vector3::UnitZ()));
  const Vector3 origin(initial.position.x(), initial.position.y(), 0);
  state.position = origin + state.rotation * chassis.center_of_mass;
  for (std::size_t i = 0; i < casters.size(); ++i)
    state.casters[i].swivel_angle = casters[i].heading();
  state.loads = loads.initial_state();
  return state;
}

void Mechanism::set_in_motion(const InitialMotion& initial, State& state) const {
  state.velocity = Velocity();
  state.velocity.chassis << initial.velocity, Vector3(0, 0, initial.yaw_rate);
  for (int dof = 0; dof < 6; ++dof) {
    const Guide& guide = fixture.guides[dof];
    if (guide.kind == Guide::Kind::kVelocity) state.velocity.chassis[dof] = guide.velocity;
    if (guide.kind == Guide::Kind::kHeld) state.velocity.chassis[dof] = 0;
  }
  if (!initial.wheels_roll) return;
  for (std::size_t i = 0; i < casters.size(); ++i) {
    const auto g = casters[i].contact(state.pose(), state.casters[i].swivel_angle);
    const Vector6& v = state.velocity.chassis;
    const Eigen::Vector2d slip = (v.head<3>() + v.tail<3>().cross(lane(g.contact, 0))).head<2>();
    Matrix2 joints;
    joints << lane(g.swivel_speed, 0).head<2>(), lane(g.axle_speed, 0).head<2>();
    if (casters[i].turns_into_motion()) {
      state.velocity.joints[i] = -joints.inverse() * slip;
    } else {
      const Eigen::Vector2d axle = joints.col(1);
      state.velocity.joints[i] = {0, -axle.dot(slip) / axle.squaredNorm()};
    }
  }
}

}  // namespace gurney
