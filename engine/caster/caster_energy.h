#pragma once

#include "engine/caster/caster_geometry.h"

namespace gurney {

/// Of one caster or of four.
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
                              const Triple<T>& velocity, const Columns<T>& fork) {
  const Triple<T>& w = motion.angular_velocity;
  const Triple<T> w_joint = (c.swivels * motion.swivel_rate) * fork.z;
  const Triple<T> w_fork = w + w_joint;
  const Triple<T> rho = fork * c.center;
  const Triple<T> r = motion.rotation * c.mount + rho;
  const Triple<T> v = velocity + cross(w, r) + cross(w_joint, rho);
  const Triple<T> turning = transposed(fork) * w_fork;
  const T spin = motion.axle_rate, half = same<T>(0.5);
  return {half * (c.mass * dot(v, v) + dot(turning, c.inertia * turning)) +
              c.axial_inertia * spin * (turning.y + half * spin),
          -c.mass * dot(motion.gravity, r)};
}

}  // namespace gurney
