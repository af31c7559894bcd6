#include "engine/solver/mechanical_energy.h"

#include <algorithm>
#include <cmath>

#include "engine/caster/caster_energy.h"

namespace gurney {

MechanicalEnergies::MechanicalEnergies(const Mechanism& mechanism) : mechanism_(mechanism) {
  for (std::size_t first = 0; first < mechanism.casters.size(); first += kLanes) {
    Casters& casters = casters_.emplace_back();
    casters.first = first;
    casters.count = std::min(kLanes, mechanism.casters.size() - first);
    for (std::size_t k = 0; k < casters.count; ++k) {
      const CasterDynamics& caster = mechanism.casters[first + k];
      set_lane(casters.body, k, caster.constants());
      set_lane(casters.tread, k, caster.tread().constants());
      casters.swivel_stiffness[k] = caster.swivel_friction().stiffness;
      casters.axle_stiffness[k] = caster.axle_friction().stiffness;
    }
  }
}

MechanicalEnergy MechanicalEnergies::at(const State& state) const {
  const Mechanism& m = mechanism_;
  const Pose pose = state.pose();
  const Vector6& v = state.velocity.chassis;
  const Vector3 w = pose.rotation.transpose() * v.tail<3>();
  MechanicalEnergy energy{
      .kinetic = 0.5 * (m.chassis.mass * v.head<3>().squaredNorm() + w.dot(m.chassis.inertia * w)),
      .gravitational = -m.total_mass * m.gravity.dot(state.position),
      .elastic = m.loads.stored_energy(state.loads) + m.tethers.stored_energy(state)};
  for (const Casters& casters : casters_) add(casters, state, pose, energy);
  return energy;
}

void MechanicalEnergies::add(const Casters& casters, const State& state, const Pose& pose,
                             MechanicalEnergy& energy) const {
  const CasterState* s = state.casters.data() + casters.first;
  const Eigen::Vector2d* rates = state.velocity.joints.data() + casters.first;
  const auto of = [&](const auto& number) {
    return gather([&](std::size_t k) -> double { return number(s[k]); });
  };
  CasterMotion<Lanes> motion;
  motion.rotation = splat<Lanes>(pose.rotation);
  motion.height = splat<Lanes>(pose.position.z());
  motion.sine = of([](const CasterState& c) { return std::sin(c.swivel_angle); });
  motion.cosine = of([](const CasterState& c) { return std::cos(c.swivel_angle); });
  motion.angular_velocity = splat<Lanes>(Vector3(state.velocity.chassis.tail<3>()));
  motion.swivel_rate = gather([&](std::size_t k) { return rates[k][0]; });
  motion.axle_rate = gather([&](std::size_t k) { return rates[k][1]; });
  motion.gravity = splat<Lanes>(mechanism_.gravity);
  CasterGeometry<Lanes> g;
  const Mat3<Lanes> fork = contact_geometry(casters.body, motion, g);
  const CasterEnergy<Lanes> moved = caster_energy(
      casters.body, motion, splat<Lanes>(Vector3(state.velocity.chassis.head<3>())), fork);

  const Vec3<Lanes> patch = {of([](const CasterState& c) { return c.tread.deflection[0]; }),
                             of([](const CasterState& c) { return c.tread.deflection[1]; }),
                             of([](const CasterState& c) { return c.tread.deflection[2]; })};
  const Lanes roll = of([](const CasterState& c) { return c.tread.roll_deflection; });
  const Lanes swivel = of([](const CasterState& c) { return c.swivel_wind; });
  const Lanes axle = of([](const CasterState& c) { return c.axle_wind; });
  const Lanes elastic =
      tread_energy<Lanes>(casters.tread, -g.height, patch, roll) +
      0.5 * (casters.swivel_stiffness * swivel * swivel + casters.axle_stiffness * axle * axle);
  for (std::size_t i = 0; i < casters.count; ++i) {
    energy.kinetic += moved.kinetic[i];
    energy.gravitational += moved.gravitational[i];
    energy.elastic += elastic[i];
  }
}

}  // namespace gurney
