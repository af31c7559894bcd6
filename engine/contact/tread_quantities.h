#pragma once

#include "engine/base/vec3.h"
#include "engine/contact/dry_friction.h"

/// Quantities in the equations of TreadLaw, for one tread or for four.
namespace gurney {

/// Constants of one tread: `Tread` and the wheel.
template <class T>
struct TreadConstants {
  T normal_stiffness{};         ///< k_n [N/m]
  T normal_damping{};           ///< c_n [N s/m]
  T tangential_stiffness{};     ///< k_t [N/m]
  T tangential_damping{};       ///< c_t [N s/m]
  T relaxation_length{};        ///< sigma [m]
  T rolling_friction_length{};  ///< Cr [m]
  T spin_radius{};              ///< r_s = w/4 [m]
  DryFrictionOf<T> roll;
};

/// One implicit stage, with what follows from its start alone: over tau, from e0 to e,
///
///     e = memory (e0 + tau u),   F = damping_rate e0 - stiffness e.
template <class T>
struct TreadStage {
  T tau{};              ///< length of the stage [s]
  T compression{};      ///< at zero u_z [m]
  T mu{};               ///< friction coefficient that holds
  T forgetting_rate{};  ///< V / sigma [1/s]
  T memory{};           ///< 1 / (1 + tau V / sigma)
  T damping_rate{};     ///< c_t / tau [N/m]
  T stiffness{};        ///< k_t + c_t / tau [N/m]
  Vec3<T> deflection;   ///< e0: at the start of the stage [m]
  T roll_deflection{};  ///< at the start of the stage [rad]

  void set_rolling(const TreadConstants<T>& c, const T& rolling_speed) {
    forgetting_rate = rolling_speed / c.relaxation_length;
    memory = 1.0 / (1.0 + tau * forgetting_rate);
    damping_rate = c.tangential_damping / tau;
    stiffness = c.tangential_stiffness + damping_rate;
  }
};

/// u of TreadLaw: those of the patch share one friction limit.
template <class T>
struct TreadRates {
  Vec3<T> patch;  ///< u_x, u_y, r_s w_spin [m/s]
  T normal{};     ///< u_z [m/s]
  T roll{};       ///< w_roll [rad/s]
};

/// f of TreadLaw.
template <class T>
struct TreadForce {
  Vec3<T> patch;  ///< F_x, F_y, T_spin / r_s [N]
  T normal{};     ///< N [N]
  T roll{};       ///< T_roll [N m]
};

/// D = -df/du; all else of the 5 x 5 is zero.
template <class T>
struct TreadSlope {
  Mat3<T> patch;       ///< of the patch, by its rates [N s/m]
  Vec3<T> by_normal;   ///< of the patch, by u_z [N s/m]
  T normal{};          ///< of N, by u_z [N s/m]
  T roll_by_normal{};  ///< of T_roll, by u_z [N s]
  T roll{};            ///< of T_roll, by w_roll [N m s]
};

/// D u: the change of f that goes with a change of -u.
template <class T>
[[gnu::always_inline]] inline TreadForce<T> operator*(const TreadSlope<T>& d,
                                                      const TreadRates<T>& u) {
  return {mul_add(u.normal, d.by_normal, d.patch * u.patch), d.normal * u.normal,
          mul_add(d.roll, u.roll, d.roll_by_normal * u.normal)};
}

}  // namespace gurney
