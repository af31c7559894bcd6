#pragma once

#include <Eigen/Core>

#include "engine/base/vector.h"
#include "engine/contact/tread_patch.h"
#include "engine/scene/equipment_model.h"

namespace gurney {

using Vector5 = Eigen::Matrix<double, 5, 1>;

/// State of a tread.
struct TreadState {
  Vector3 deflection =
      Vector3::Zero();         ///< of the patch: x, y (floor axes) and (w/4) times spin [m]
  double roll_deflection = 0;  ///< wind-up of the rolling resistance [rad]
  bool sliding = false;        ///< mu_k holds; false: mu_s holds
  bool rolling = false;        ///< the rolling resistance is overcome
};

/// Force of the floor on a wheel (docs/theory/tread.md).
///
/// Rates u = (u_x, u_y, u_z, r_s w_spin, w_roll): velocity of the material contact point of the
/// wheel in floor axes, spin about the vertical times r_s = w/4, rotation about the axle's
/// horizontal direction. Forces f = (F_x, F_y, N, T_spin / r_s, T_roll), so that f . u is the power
/// given to the wheel.
///
/// Law of a tread. With the compression d and d' = -u_z:
///
///     N  = k_n d + min(max(c_n d', -k_n d), k_n d)  for d > 0, else 0   (never pulls, continuous)
///     e' = (u_x, u_y, r_s w_spin) - (V / sigma) e - slip
///     F  = -(k_t e + c_t e'),  |F| <= mu N
///     |T_roll| <= Cr N, opposed to the rolling
///
/// e is the stored deflection (two translations and spin) and V = R |w_roll| the rolling speed: a
/// rolling patch forgets its deflection over sigma (the relaxation length of the tyre models of von
/// Schlippe and Pacejka). Translation and spin share one friction limit, a sphere in (F_x, F_y,
/// T_spin / r_s); r_s is a quarter of the patch width, for which mu N r_s is the scrub torque of a
/// uniform line contact. mu = mu_s until the patch slides, mu_k from then until it sticks again:
/// `sliding` remembers.
///
/// Limits: the deflection does not depend on the load; no camber force, no heat, no wear.
class TreadLaw {
 public:
  TreadLaw(const Tread& tread, double wheel_radius)
      : tread_(tread),
        constants_{
            tread.normal_stiffness,
            tread.normal_damping,
            tread.tangential_stiffness,
            tread.tangential_damping,
            tread.relaxation_length,
            tread.rolling_friction_length,
            tread.patch_width / 4,
            {kStickStiffnessRatio * tread.tangential_stiffness * wheel_radius * wheel_radius, 0}} {}

  struct Result {
    Vector5 force = Vector5::Zero();
    TreadState end;
    double compression = 0;       ///< at the end of the stage [m]
    double compression_rate = 0;  ///< [m/s]
    double sliding_power = 0;     ///< dissipated by sliding and scrub, >= 0 [W]
    double rolling_power = 0;     ///< by rolling resistance [W]
    double relaxation_power = 0;
    double damping_power = 0;  ///< by c_n and c_t [W]
    double slip_speed = 0;     ///< of the sliding patch, translation only [m/s]
    double spring_rates = 0;   ///< sum of k x'^2 over the springs of the tread [W/s]
  };

  double static_force(double compression) const {
    return compression > 0 ? tread_.normal_stiffness * compression : 0;
  }
  double spin_radius() const { return constants_.spin_radius; }
  double tangential_stiffness() const { return tread_.tangential_stiffness; }

  const TreadConstants<double>& constants() const { return constants_; }
  double friction(const TreadState& state) const {
    return state.sliding ? tread_.kinetic_friction : tread_.static_friction;
  }

 private:
  Tread tread_;
  TreadConstants<double> constants_;
};

}  // namespace gurney
