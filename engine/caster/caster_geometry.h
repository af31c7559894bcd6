#pragma once

#include "engine/base/units.h"
#include "engine/base/vec3.h"

/// The mechanics of CasterDynamics, for one caster or for four.
namespace gurney {

/// Constants of one caster. `whole` is fork and wheel as one body, the wheel as not spinning.
template <class T>
struct CasterConstants {
  T mass{};           ///< m: of the whole [kg]
  T axial_inertia{};  ///< I_a: of the wheel about its axle [kg m2]
  T radius{};         ///< of the wheel [m]
  T width{};          ///< of the wheel [m]
  T swivels{};        ///< 1, or 0 of a fork that does not swivel: it then has no swivel rate
  T spin_radius{};    ///< r_s of TreadLaw [m]
  Vec3<T> mount;      ///< chassis axes, relative to O [m]
  Vec3<T> wheel_center, center;  ///< of the wheel, of the whole; fork axes, from the mount [m]
  Mat3<T> inertia;               ///< of the whole about its centre, fork axes [kg m2]
};

/// Where the chassis is and how all moves; floor axes.
template <class T>
struct CasterMotion {
  Mat3<T> rotation;          ///< R: chassis to floor axes
  T height{};                ///< of O above the floor [m]
  T sine{}, cosine{};        ///< of the swivel angle psi
  Vec3<T> angular_velocity;  ///< w: of the chassis [rad/s]
  T swivel_rate{};           ///< psi' [rad/s]
  T axle_rate{};             ///< theta' [rad/s]
  Vec3<T> gravity;           ///< g: acceleration that acts on every mass [m/s2]
};

/// CasterDynamics::Geometry by what is not zero in its matrices; floor axes, about O.
template <class T>
struct CasterGeometry {
  Vec3<T> swivel_axis;   ///< s, unit
  Vec3<T> axle;          ///< a, unit, to the left
  Vec3<T> axle_level;    ///< l: horizontal direction of the axle, unit
  Vec3<T> mount;         ///< relative to O [m]
  Vec3<T> wheel_center;  ///< relative to O [m]
  Vec3<T> contact;       ///< p: lowest point of the undeformed wheel, relative to O [m]
  T height{};            ///< of p above the floor; kHeightOfLying of a wheel that lies [m]

  /// Mass matrix. Chassis: m, m [r]x and `inertia`; by swivel and axle rate, `coupling_*` and
  /// `spin_momentum`; of the joints, `joint_*` and I_a.
  Vec3<T> mass_moment;       ///< m r: of the caster's mass about O [kg m]
  Mat3<T> inertia;           ///< about O [kg m2]
  Vec3<T> coupling_linear;   ///< momentum by the swivel rate [kg m]
  Vec3<T> coupling_angular;  ///< angular momentum about O by the swivel rate [kg m2]
  Vec3<T> spin_momentum;     ///< angular momentum by the axle rate, I_a a [kg m2]
  T joint_inertia{};         ///< of the swivel; 1 where it does not swivel [kg m2]
  T joint_coupling{};        ///< between swivel and axle [kg m2]

  /// Bias: forces at zero acceleration, of inertia minus weight.
  Vec3<T> bias_linear;   ///< [N]
  Vec3<T> bias_angular;  ///< about O [N m]
  T bias_swivel{};       ///< [N m]
  T bias_axle{};         ///< [N m]

  /// Columns of the contact Jacobian that belong to the joints (contact_jacobian.h).
  Vec3<T> swivel_speed, axle_speed;  ///< of the contact point, by swivel and axle rate [m]
  T swivel_spin{}, axle_spin{};      ///< r_s w_spin, by each [m]
  T swivel_roll{}, axle_roll{};      ///< w_roll, by each
};

/// A wheel whose axle is steeper lies on its side, more than 60 degrees from upright
/// (CasterDynamics::lies): it has no contact on its tread and counts as this far above the floor.
inline constexpr double kSineOfLying = 0.866;
inline constexpr double kHeightOfLying = 1;  // [m]

/// A wheel that leans further touches the floor beside the middle of its tread (assumption).
inline constexpr double kCrownBegins = 10 * kRadiansPerDegree;
inline constexpr double kSineOfCrown = 0.17364817766693033;  // of kCrownBegins

/// From the wheel's centre to the lowest point of a tread that leans further than kCrownBegins.
/// @param axle_z  z component of the axle
/// @param up      unit, in the wheel's plane, the steepest
Vector3 crown_contact(double axle_z, double radius, double width, const Vector3& up,
                      const Vector3& axle);

/// Moves `down`, the lowest point of a disc, to that of the crowned tread where a wheel leans.
template <class T>
[[gnu::noinline, gnu::cold]] void lean_on_crown(const CasterConstants<T>& c, const Vec3<T>& up,
                                                const Vec3<T>& axle, Vec3<T>& down) {
  for (std::size_t k = 0; k < kLanesOf<T>; ++k)
    if (std::abs(lane(axle.z, k)) > kSineOfCrown)
      set_lane(down, k,
               crown_contact(lane(axle.z, k), lane(c.radius, k), lane(c.width, k), lane(up, k),
                             lane(axle, k)));
}

/// From the wheel's centre to the lowest point of its tread.
template <class T>
[[gnu::always_inline]] inline Vec3<T> lowest_of_tread(const CasterConstants<T>& c,
                                                      const Vec3<T>& axle) {
  // The lowest point of the disc lies against z - (z . a) a, its part in the wheel's plane.
  const Vec3<T> up = normalized<T>({-axle.z * axle.x, -axle.z * axle.y, 1.0 - axle.z * axle.z});
  Vec3<T> down = -c.radius * up;
  if (any(abs(axle.z) > kSineOfCrown)) lean_on_crown(c, up, axle, down);
  return down;
}

/// Contact kinematics only: all but the masses.
/// @returns F, the rotation from fork to floor axes
template <class T>
[[gnu::always_inline]] inline Mat3<T> contact_geometry(const CasterConstants<T>& c,
                                                       const CasterMotion<T>& motion,
                                                       CasterGeometry<T>& out) {
  const Mat3<T>& R = motion.rotation;
  // F = R times the rotation by psi about z.
  const Mat3<T> fork = {mul_add(motion.sine, R.y, motion.cosine * R.x),
                        mul_add(motion.cosine, R.y, -motion.sine * R.x), R.z};
  const Vec3<T>&s = fork.z, &a = fork.y;
  out.swivel_axis = s;
  out.axle = a;
  out.axle_level = normalized<T>({a.x, a.y, T{}});
  out.mount = R * c.mount;
  const Vec3<T> arm = fork * c.wheel_center;
  const Vec3<T> down = lowest_of_tread(c, a);
  out.wheel_center = out.mount + arm;
  out.contact = out.wheel_center + down;
  out.height =
      select(abs(a.z) > kSineOfLying, splat<T>(kHeightOfLying), motion.height + out.contact.z);

  out.swivel_speed = c.swivels * cross(s, arm + down);
  out.axle_speed = cross(a, down);
  out.swivel_spin = c.swivels * c.spin_radius * s.z;
  out.axle_spin = c.spin_radius * a.z;
  out.swivel_roll = c.swivels * dot(s, out.axle_level);
  out.axle_roll = dot(a, out.axle_level);
  return fork;
}

/// Mass matrix and bias of a caster.
/// With rho from the mount to the centre of mass C of the caster, r = O to C, and J its inertia
/// about C, the momentum of the whole at (v, w, psi', theta') is
///
///     linear           m (v + w x r + psi' s x rho)
///     angular about O  r x linear + J (w + psi' s) + I_a theta' a.
///
/// Its coefficients are the mass matrix. The bias is the rate of this momentum at constant rates,
/// less the weight.
template <class T>
void caster_geometry(const CasterConstants<T>& c, const CasterMotion<T>& motion,
                     CasterGeometry<T>& out) {
  const Mat3<T> fork = contact_geometry(c, motion, out);
  const Vec3<T>&s = fork.z, &a = fork.y;

  const Vec3<T> rho = fork * c.center;
  const Vec3<T> r = out.mount + rho;
  const Vec3<T> mr = c.mass * r;
  const Mat3<T> J = fork * c.inertia * transposed(fork);
  const Vec3<T> d = c.swivels * cross(s, rho);  // velocity of C by the swivel rate
  const Vec3<T> Js = c.swivels * (J * s);
  const Vec3<T> spin_momentum = c.axial_inertia * a;
  out.mass_moment = mr;
  out.inertia = J + (diagonal(dot(mr, r)) - outer(mr, r));  // parallel axes: - m [r]x [r]x
  out.coupling_linear = c.mass * d;
  out.coupling_angular = cross(mr, d) + Js;
  out.spin_momentum = spin_momentum;
  out.joint_inertia = select(c.swivels > 0.0, c.mass * dot(d, d) + dot(s, Js), splat<T>(1));
  out.joint_coupling = c.swivels * dot(spin_momentum, s);

  const Vec3<T>& w = motion.angular_velocity;
  const T psi = c.swivels * motion.swivel_rate, theta = motion.axle_rate;
  const Vec3<T> w_fork = w + psi * s;
  const Vec3<T> s_rate = cross(w, s);
  const Vec3<T> r_rate = cross(w, r) + psi * cross(s, rho);
  const Vec3<T> linear =
      c.mass * (cross(w, r_rate) + psi * (cross(s_rate, rho) + cross(s, cross(w_fork, rho))) -
                motion.gravity);
  const Vec3<T> swivel_acceleration = psi * s_rate;
  const Vec3<T> angular =
      J * swivel_acceleration + cross(w_fork, J * w_fork) + theta * cross(w_fork, spin_momentum);
  out.bias_linear = linear;
  out.bias_angular = cross(r, linear) + angular;
  out.bias_swivel = dot(d, linear) + c.swivels * dot(s, angular);
  out.bias_axle = dot(spin_momentum, swivel_acceleration);
}

}  // namespace gurney
