#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "engine/run/simulate.h"

namespace gurney::drawn {

/// Items that stand anyhow: heavy, light, high, off centre, on hard, soft and undamped treads with
/// or without a trail, between walls. They fall, lean on walls and lie with their wheels in
/// corners.
class Draw {
 public:
  explicit Draw(unsigned seed) : bits_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_()) / 4294967296.0;
  }
  double log_between(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
  bool happens(double probability) { return between(0, 1) < probability; }

 private:
  std::mt19937 bits_;
};

struct Run {
  Scene scene = scene_of({});
  FloorMotion floor;
  SimulationSettings settings;
};

inline Caster caster(Draw& d, double mass) {
  Caster c;
  c.wheel_radius = d.between(0.02, 0.1);
  c.height = c.wheel_radius * d.between(1.5, 2.8);
  c.wheel_width = c.wheel_radius * d.between(0.3, 0.8);
  c.trail = d.happens(0.1) ? 0 : d.between(0, 0.1);
  c.wheel_mass = mass * d.log_between(0.001, 0.01);
  c.fork_mass = mass * d.log_between(0.0005, 0.005);
  const double r = c.wheel_radius;
  c.wheel_axial_inertia = d.between(0.5, 0.9) * c.wheel_mass * r * r;
  c.wheel_transverse_inertia = 0.6 * c.wheel_axial_inertia;
  const Vector3 fork(std::max(c.trail, 0.02), c.wheel_width * 1.3, c.height - r);
  c.fork_center_of_mass = {-0.5 * c.trail, 0, -0.3 * c.height};
  c.fork_inertia = solid_box_inertia(c.fork_mass, fork);
  // k_n of 1e4 to 1e7 N/m belongs to 50 kg; damping from next to none to nearly critical.
  Tread& t = c.tread;
  t.normal_stiffness = std::max(d.log_between(1e4, 1e7) * mass / 50, 500 * mass);
  const double critical = 2 * std::sqrt(t.normal_stiffness * mass / 4);
  t.normal_damping = critical * d.log_between(1e-3, 1);
  t.tangential_stiffness = t.normal_stiffness * d.between(0.2, 0.9);
  t.tangential_damping = critical * d.log_between(1e-3, 0.5);
  t.relaxation_length = d.log_between(1e-3, 0.03);
  t.patch_width = d.between(0, c.wheel_width);
  t.rolling_friction_length = d.log_between(1e-4, 4e-3);
  t.static_friction = d.between(0.1, 1);
  t.kinetic_friction = t.static_friction * d.between(0.5, 1);
  c.axle.coulomb = d.happens(0.5) ? 0 : 0.05;
  c.swivel.coulomb = d.between(0, 0.2);
  c.swivels = d.happens(0.8);
  if (d.happens(0.3)) c.brake_torque = d.log_between(1, 50);
  if (d.happens(0.1)) c.swivel_lock_torque = std::numeric_limits<double>::infinity();
  return c;
}

inline EquipmentModel item(Draw& d) {
  EquipmentModel model;
  const double mass = model.chassis_mass = d.log_between(1, 2000);
  const Vector3 size(d.between(0.2, 1), d.between(0.2, 0.8), d.between(0.3, 2));
  const int count = 3 + static_cast<int>(d.between(0, 4));
  const Caster shared = caster(d, mass);
  const double ring = 2 * std::numbers::pi / count, phase = d.between(0, ring);
  for (int i = 0; i < count; ++i) {
    Caster& c = model.casters.emplace_back(d.happens(0.5) ? shared : caster(d, mass));
    c.height = shared.height;
    c.wheel_radius = shared.wheel_radius;
    c.mount = {0.5 * size.x() * std::cos(phase + i * ring),
               0.5 * size.y() * std::sin(phase + i * ring), c.height};
    c.heading = d.between(-std::numbers::pi, std::numbers::pi);
  }
  const double bottom = d.between(0.5, 1) * shared.height;
  model.shape = {{Vector3(0, 0, bottom + 0.5 * size.z()), size}};
  model.chassis_center_of_mass = {d.between(-0.1, 0.1) * size.x(), d.between(-0.1, 0.1) * size.y(),
                                  bottom + d.between(0.3, 0.9) * size.z()};
  model.chassis_inertia = solid_box_inertia(mass, size);
  return model;
}

inline RoomShape wall(const char* name, double x, double y) {
  RoomShape wall;
  wall.name = name;
  wall.position = {x, y, 1.25};
  wall.shape = RoomBox{x != 0 ? Vector3(0.1, 6, 2.5) : Vector3(6, 0.1, 2.5)};
  return wall;
}

inline FloorMotion shaking(Draw& d, double duration) {
  const double pga = d.log_between(0.1, 5) * 9.80665, step = 0.005;
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, std::lround(duration / step) + 1);
  for (int axis = 0; axis < 3; ++axis)
    for (int wave = 0; wave < 4; ++wave) {
      const double f = d.log_between(0.5, 8), phase = d.between(0, 2 * std::numbers::pi);
      for (Eigen::Index i = 0; i < a.cols(); ++i) {
        const double t = step * static_cast<double>(i);
        a(axis, i) += (axis == 2 ? 0.2 : 0.4) * pga * std::sin(std::numbers::pi * t / duration) *
                      std::sin(2 * std::numbers::pi * f * t + phase);
      }
    }
  return {step, a};
}

inline Run run(unsigned seed) {
  Draw d(seed);
  Run run;
  PlacedItem& placed = run.scene.items[0];
  placed.name = "item";
  placed.model = item(d);
  placed.initial.yaw = d.between(-std::numbers::pi, std::numbers::pi);
  if (d.happens(0.8)) {
    double reach = 0;
    for (const Caster& c : placed.model.casters)
      reach = std::max(reach, c.mount.head<2>().norm() +
                                  std::hypot(c.trail + c.wheel_radius, 0.5 * c.wheel_width));
    const Vector3& size = placed.model.shape[0].size;
    reach = std::max(reach, 0.5 * std::hypot(size.x(), size.y()));
    const double away = reach + 0.05 + d.log_between(0.02, 1);
    run.scene.room = {wall("east", away, 0), wall("west", -away, 0), wall("north", 0, away),
                      wall("south", 0, -away)};
  }
  run.floor = shaking(d, 2);
  run.settings.settle_time = 2;
  return run;
}

}  // namespace gurney::drawn
