#pragma once

#include <array>

#include "engine/caster/caster_geometry.h"

namespace gurney {

/// Velocities of the contact u = Jc V + Jl q' (CasterDynamics::Geometry).
template <class T>
struct ContactRates {
  Triple<T> velocity;
  T spin{}, roll{};
};

template <class T>
[[gnu::always_inline]] inline ContactRates<T> contact_rates(const CasterGeometry<T>& g,
                                                            const T& spin_radius,
                                                            const Triple<T>& v, const Triple<T>& w,
                                                            const T& swivel, const T& axle) {
  const Triple<T>&p = g.contact, &level = g.axle_level;
  const Triple<T>&s = g.swivel_speed, &a = g.axle_speed;
  const auto joints = [&](const T& by_swivel, const T& by_axle) {
    return madd(by_axle, axle, by_swivel * swivel);
  };
  return {{madd(-p.y, w.z, madd(p.z, w.y, v.x)) + joints(s.x, a.x),
           madd(p.x, w.z, madd(-p.z, w.x, v.y)) + joints(s.y, a.y),
           madd(-p.x, w.y, madd(p.y, w.x, v.z)) + joints(s.z, a.z)},
          spin_radius * w.z + joints(g.swivel_spin, g.axle_spin),
          level.x * w.x + (level.y * w.y + level.z * w.z) +
              (g.swivel_roll * swivel + g.axle_roll * axle)};
}

template <class T>
struct ContactForces {
  T x{}, y{}, normal{}, spin{}, roll{};
};

/// J' times forces at the contact: six of the chassis, then those of swivel and axle.
template <class T>
[[gnu::always_inline]] inline std::array<T, 8> generalised(const CasterGeometry<T>& g,
                                                           const T& spin_radius,
                                                           const ContactForces<T>& f) {
  const Triple<T>&p = g.contact, &level = g.axle_level;
  const auto on_joint = [&](const Triple<T>& speed, const T& spin, const T& roll) {
    return ((speed.x * f.x + speed.z * f.normal) + (speed.y * f.y + spin * f.spin)) + roll * f.roll;
  };
  return {f.x,
          f.y,
          f.normal,
          (p.y * f.normal + -p.z * f.y) + level.x * f.roll,
          (p.z * f.x + -p.x * f.normal) + level.y * f.roll,
          (-p.y * f.x + (p.x * f.y + spin_radius * f.spin)) + level.z * f.roll,
          on_joint(g.swivel_speed, g.swivel_spin, g.swivel_roll),
          on_joint(g.axle_speed, g.axle_spin, g.axle_roll)};
}

}  // namespace gurney
