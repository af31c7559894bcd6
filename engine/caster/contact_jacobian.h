#pragma once

#include "engine/caster/caster_geometry.h"
#include "engine/contact/tread_quantities.h"

/// The contact Jacobian J of a caster: u = J (v, w, psi', theta'), with the rates u of TreadLaw, v
/// of O and w of the chassis (floor axes), swivel rate psi' and axle rate theta'. With p, s, a and l
/// of CasterGeometry and q from the mount, c from the wheel's centre to p,
///
///               v     w          psi'          theta'
///     u_x,y,z | I   -[p]x       s x q          a x c       |
///     spin    | 0   r_s z'      r_s z . s      r_s z . a   |
///     roll    | 0   l'          l . s          l . a       |
namespace gurney {

/// Velocities v, w, psi', theta' of chassis and joints, or forces on them.
template <class T>
struct CasterVector {
  Vec6<T> chassis;     ///< of O, about O [m/s, rad/s] or [N, N m]
  T swivel{}, axle{};  ///< [rad/s] or [N m]
};

/// J v.
template <class T>
[[gnu::always_inline]] inline TreadRates<T> contact_rates(const CasterGeometry<T>& g,
                                                          const T& spin_radius,
                                                          const CasterVector<T>& v) {
  const Vec3<T>& w = v.chassis.angular;
  const Vec3<T> velocity =
      v.chassis.linear + cross(w, g.contact) + v.swivel * g.swivel_speed + v.axle * g.axle_speed;
  const T spin = spin_radius * w.z + v.swivel * g.swivel_spin + v.axle * g.axle_spin;
  const T roll = dot(g.axle_level, w) + v.swivel * g.swivel_roll + v.axle * g.axle_roll;
  return {{velocity.x, velocity.y, spin}, velocity.z, roll};
}

/// J' f: forces at the contact on chassis and joints.
template <class T>
[[gnu::always_inline]] inline CasterVector<T> generalised(const CasterGeometry<T>& g,
                                                          const T& spin_radius,
                                                          const TreadForce<T>& f) {
  const Vec3<T> force = {f.patch.x, f.patch.y, f.normal};
  const T& spin = f.patch.z;
  const Vec3<T> torque = mul_add(f.roll, g.axle_level, cross(g.contact, force));
  return {{force, {torque.x, torque.y, mul_add(spin_radius, spin, torque.z)}},
          dot(g.swivel_speed, force) + (g.swivel_spin * spin + g.swivel_roll * f.roll),
          dot(g.axle_speed, force) + (g.axle_spin * spin + g.axle_roll * f.roll)};
}

}  // namespace gurney
