#pragma once

#include "engine/base/triple.h"

/// The mechanics of CasterDynamics, for one caster or for four.
namespace gurney {

/// What differs between casters; members as of CasterDynamics.
template <class T>
struct CasterConstants {
  T mass{}, axial_inertia{}, radius{}, width{};
  T swivels{};  ///< 1 or 0
  T spin_radius{};
  Triple<T> mount, wheel_center, center;
  Columns<T> inertia;
};

/// Where the chassis is and how all moves.
template <class T>
struct CasterMotion {
  Columns<T> rotation;
  T height{};          ///< of O above the floor [m]
  T sine{}, cosine{};  ///< of the swivel angle
  Triple<T> angular_velocity;
  T swivel_rate{}, axle_rate{};
  Triple<T> gravity;
};

/// CasterDynamics::Geometry by what is not zero in its matrices.
template <class T>
struct CasterGeometry {
  Triple<T> swivel_axis, axle, axle_level, mount, wheel_center, contact;
  T height{};

  Triple<T> mass_moment;  ///< m r: of the mass about O
  Columns<T> inertia;     ///< about O
  Triple<T> coupling_linear, coupling_angular, spin_momentum;
  T joint_inertia{}, joint_coupling{};
  Triple<T> bias_linear, bias_angular;
  T bias_swivel{}, bias_axle{};

  Triple<T> swivel_speed, axle_speed;  ///< of the contact point, by the joint rates
  T swivel_spin{}, axle_spin{}, swivel_roll{}, axle_roll{};
};

/// A wheel whose axle is steeper lies on its side (CasterDynamics::lies).
inline constexpr double kSineOfLying = 0.866;

/// Of the tread's lowest point from the wheel's centre, where it leans out of its crown: `down`
/// is that of a disc along `up`.
Vector3 crown_contact(double axle_z, double radius, double width, const Vector3& up,
                      const Vector3& axle);
/// Of the 10 degrees from which on a wheel leans so far.
inline constexpr double kSineOfCrown = 0.17364817766693033;

template <class T>
[[gnu::noinline, gnu::cold]] void lean_on_crown(const CasterConstants<T>& c, const Triple<T>& up,
                                                const Triple<T>& axle, Triple<T>& down) {
  for (std::size_t k = 0; k < kLanesOf<T>; ++k)
    if (std::abs(of_lane(axle.z, k)) > kSineOfCrown)
      put_lane(down, k,
               crown_contact(of_lane(axle.z, k), of_lane(c.radius, k), of_lane(c.width, k),
                             of_lane(up, k), of_lane(axle, k)));
}

template <class T>
[[gnu::always_inline]] inline Triple<T> lowest_of_tread(const CasterConstants<T>& c,
                                                        const Triple<T>& axle) {
  // The lowest point of the disc lies against the component of z in the wheel's plane.
  const Triple<T> up =
      normalized<T>({T{} - axle.z * axle.x, T{} - axle.z * axle.y, same<T>(1) - axle.z * axle.z});
  Triple<T> down = -c.radius * up;
  const Mask<T> leans = magnitude(axle.z) > same<T>(kSineOfCrown);
  if (any(leans)) lean_on_crown(c, up, axle, down);
  return down;
}

/// m (r x)^2 of a mass at r whose moment is `moment`.
template <class T>
Columns<T> squared_arm(const Triple<T>& moment, const Triple<T>& r) {
  const Triple<T>& m = moment;
  return {{madd(m.y, -r.y, -m.z * r.z), -m.x * -r.y, m.x * r.z},
          {m.y * r.x, madd(-m.x, r.x, m.z * -r.z), -m.y * -r.z},
          {-m.z * -r.x, m.z * r.y, -m.y * r.y + m.x * -r.x}};
}

/// What of the geometry the floor sees; all of it but the masses.
/// @returns the rotation from fork to floor axes
template <class T>
[[gnu::always_inline]] inline Columns<T> contact_geometry(const CasterConstants<T>& c,
                                                          const CasterMotion<T>& motion,
                                                          CasterGeometry<T>& out) {
  const Columns<T>& R = motion.rotation;
  const T cosine = motion.cosine, sine = motion.sine;
  const auto turned = [&](const T& x, const T& y) -> Triple<T> {
    return {madd(R.y.x, y, R.x.x * x), madd(R.y.y, y, R.x.y * x), R.x.z * x + R.y.z * y};
  };
  const Columns<T> fork = {turned(cosine, sine), turned(-sine, cosine), R.z};
  const Triple<T>&s = fork.z, &a = fork.y;
  out.swivel_axis = s;
  out.axle = a;
  out.mount = R * c.mount;
  const Triple<T> arm = fork * c.wheel_center;
  out.wheel_center = out.mount + arm;
  const Triple<T> down = lowest_of_tread(c, a);
  out.contact = out.wheel_center + down;
  out.height =
      select(magnitude(a.z) > same<T>(kSineOfLying), same<T>(1), motion.height + out.contact.z);
  out.axle_level = normalized<T>({a.x, a.y, T{}});

  out.swivel_speed = c.swivels * cross(s, arm + down);
  out.axle_speed = cross(a, down);
  out.swivel_spin = c.swivels * c.spin_radius * s.z;
  out.axle_spin = c.spin_radius * a.z;
  out.swivel_roll = c.swivels * dot(s, out.axle_level);
  out.axle_roll = dot(a, out.axle_level);
  return fork;
}

template <class T>
void caster_geometry(const CasterConstants<T>& c, const CasterMotion<T>& motion,
                     CasterGeometry<T>& out) {
  const Columns<T> fork = contact_geometry(c, motion, out);
  const Triple<T>&s = fork.z, &a = fork.y;

  // Inertia: momentum of the caster m v_L and J w_f + I_a theta' a about its centre.
  const Triple<T> rho = fork * c.center;
  const Triple<T> r = out.mount + rho;
  const Columns<T> J = fork * c.inertia * transposed(fork);
  const Triple<T> d = c.swivels * cross(s, rho);
  const Triple<T> Js = c.swivels * (J * s);
  const Triple<T> spin_momentum = c.axial_inertia * a;
  out.mass_moment = c.mass * r;
  const Columns<T> squared = squared_arm(out.mass_moment, r);
  out.inertia = {J.x - squared.x, J.y - squared.y, J.z - squared.z};
  out.coupling_linear = c.mass * d;
  out.coupling_angular = c.mass * cross(r, d) + Js;
  out.spin_momentum = spin_momentum;
  out.joint_inertia = select(c.swivels > T{}, c.mass * dot(d, d) + dot(s, Js), same<T>(1));
  out.joint_coupling = c.swivels * dot(spin_momentum, s);

  const Triple<T>& w = motion.angular_velocity;
  const T psi = c.swivels * motion.swivel_rate, theta = motion.axle_rate;
  const Triple<T> w_fork = w + psi * s;
  const Triple<T> s_rate = cross(w, s);
  const Triple<T> r_rate = cross(w, r) + psi * cross(s, rho);
  const Triple<T> linear =
      c.mass * (cross(w, r_rate) + psi * (cross(s_rate, rho) + cross(s, cross(w_fork, rho))) -
                motion.gravity);
  const Triple<T> swivel_rate_change = psi * s_rate;
  const Triple<T> angular =
      J * swivel_rate_change + cross(w_fork, J * w_fork) + theta * cross(w_fork, spin_momentum);
  out.bias_linear = linear;
  out.bias_angular = cross(r, linear) + angular;
  out.bias_swivel = dot(d, linear) + c.swivels * dot(s, angular);
  out.bias_axle = dot(spin_momentum, swivel_rate_change);
}

}  // namespace gurney
