#pragma once

#include "engine/caster/caster_geometry.h"

namespace gurney {

/// Energies of one caster or of four.
template <class T>
struct CasterEnergy {
  T kinetic{};        ///< [J]
  T gravitational{};  ///< of the caster's place relative to O [J]
};

/// m v^2 / 2 + w J w / 2 + I_a theta' a w + I_a theta'^2 / 2, with v of the caster's centre of
/// mass, w = w_chassis + psi' s of its fork and theta' of its wheel about its axle a; and -m g r.
/// It uses none of the mass matrices of caster_geometry, which the balance of energy so checks.
/// @param velocity  of O [m/s]
/// @param fork      rotation from fork to floor axes (contact_geometry)
template <class T>
CasterEnergy<T> caster_energy(const CasterConstants<T>& c, const CasterMotion<T>& motion,
                              const Vec3<T>& velocity, const Mat3<T>& fork) {
  const Vec3<T>& w = motion.angular_velocity;
  const Vec3<T> w_joint = (c.swivels * motion.swivel_rate) * fork.z;
  const Vec3<T> w_fork = w + w_joint;
  const Vec3<T> rho = fork * c.center;
  const Vec3<T> r = motion.rotation * c.mount + rho;
  const Vec3<T> v = velocity + cross(w, r) + cross(w_joint, rho);
  const Vec3<T> turning = transposed(fork) * w_fork;
  const T spin = motion.axle_rate, half = splat<T>(0.5);
  return {half * (c.mass * dot(v, v) + dot(turning, c.inertia * turning)) +
              c.axial_inertia * spin * (turning.y + half * spin),
          -c.mass * dot(motion.gravity, r)};
}

}  // namespace gurney
