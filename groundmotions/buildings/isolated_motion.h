#pragma once

#include <array>
#include <vector>

#include "engine/base/vector.h"
#include "groundmotions/buildings/isolation.h"
#include "groundmotions/buildings/modal_building.h"

namespace gurney::groundmotions {

/// Energies of an isolated building for each kilogram above the isolators, relative to the ground
/// (Uang & Bertero 1990, Earthquake Engineering and Structural Dynamics 19, 77-90) [J/kg]. Every
/// term comes from its own force; none is the remainder.
struct IsolationEnergy {
  double input = 0;       ///< work of -a_ground on the building, and what it was released with
  double kinetic = 0;     ///< now
  double strain = 0;      ///< of the building above the isolators, now
  double restoring = 0;   ///< work taken by k u; at constant load the energy stored in it
  double hysteresis = 0;  ///< work taken by q z; up to q u_y / 2 of it can come back
  double damping = 0;     ///< dissipated by the modes and by c v

  double closure() const {  ///< 0 if the account closes
    return input - kinetic - strain - restoring - hysteresis - damping;
  }
};

/// The two horizontal motions of a linear building on an isolation layer, solved together.
///
/// With m_i the effective mass of mode i, all as shares of what the layer carries, for each axis
///
///     q_i'' + 2 zeta_i omega_i q_i' + omega_i^2 q_i = -(a_ground + u'')
///     (a_ground + u'') + sum_i m_i q_i'' = -f(u, v, z, n)
///
/// by the implicit midpoint rule: second order, stable for any step. The base moves straight in a
/// step, so the work of the hysteresis is exact for that increment (`slide`) and the energies close
/// to the tolerance of the solve, whatever the step.
class IsolatedMotion {
 public:
  /// @param axes       h1, h2; effective masses relative to the building without its base floor
  /// @param time_step  > 0 [s]
  IsolatedMotion(const Isolation& isolation, const std::array<ModalAxis, 2>& axes,
                 double time_step);

  /// A step of time that the fixed-point solve surely converges with and that resolves the fastest
  /// vibration by some six points [s].
  static double largest_step(const Isolation& isolation, const std::array<ModalAxis, 2>& axes);

  /// Sets the base off its place, the building above at rest relative to it.
  /// @param z  state of the hysteresis, |z| <= 1
  void release(const Vector2& displacement, const Vector2& velocity, const Vector2& z);

  /// One step of time.
  /// @param ground0, ground1  acceleration of the ground at its begin and end; z up [m/s2]
  void step(const Vector3& ground0, const Vector3& ground1);

  const Vector2& displacement() const { return u_; }     ///< of the base relative to the ground [m]
  const Vector2& velocity() const { return v_; }         ///< likewise [m/s]
  const Vector2& hysteresis() const { return z_; }       ///< z [-]
  Vector2 force() const;                                 ///< f [m/s2]
  Vector2 floor_acceleration(Eigen::Index floor) const;  ///< absolute; 0: base floor [m/s2]
  /// How far a floor dips towards h1 and h2, and the second derivative [rad], [rad/s2].
  Vector2 floor_dip(Eigen::Index floor) const;
  Vector2 floor_dip_acceleration(Eigen::Index floor) const;
  double storey_drift() const;             ///< largest of the building above, h1 or h2 [m]
  bool lifted() const { return lifted_; }  ///< the vertical motion took all load off at some time
  IsolationEnergy energy() const;

 private:
  /// A mode with what the midpoint rule needs of it: with d = 1 + zeta omega h + (omega h / 2)^2 its
  /// mean velocity in a step is w - (h / 2) (a_base + pull) / d.
  struct ModeState {
    ModeState(const Mode& mode, double effective_mass, double time_step);

    double absolute_acceleration() const { return -(viscosity * w + stiffness * q); }
    double pull() const { return (viscosity + step / 2 * stiffness) * w + stiffness * q; }

    double mass, step;
    double viscosity;                 ///< 2 zeta omega [1/s]
    double stiffness;                 ///< omega^2 [1/s2]
    double share;                     ///< 1 / d
    Eigen::VectorXd shape, rotation;  ///< at every floor
    double q = 0, w = 0;
  };

  /// @returns sum of m_i times the increments of q_i [m]
  double move_modes(std::size_t axis, double base_acceleration);

  Isolation isolation_;
  double h_;
  std::array<std::vector<ModeState>, 2> modes_;
  std::array<double, 2> free_mass_;  ///< not in the modes: base floor and modes left out
  Vector2 inertia_;                  ///< 1 - sum_i m_i / d_i: of the base, modes eliminated
  Vector2 u_ = Vector2::Zero(), v_ = Vector2::Zero(), z_ = Vector2::Zero();
  double load_ = 1;  ///< n at the end of the last step
  bool lifted_ = false;
  IsolationEnergy energy_;
};

}  // namespace gurney::groundmotions
