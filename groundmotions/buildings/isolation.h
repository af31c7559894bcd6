#pragma once

#include <limits>
#include <string>

#include "engine/base/vector.h"

namespace gurney::groundmotions {

/// An isolation layer between the ground and the base of a building, the same in every horizontal
/// direction, as one bearing below the centre of mass. All forces are for each kilogram of what the
/// layer carries, so they are accelerations. With u, v the displacement and velocity of the base
/// relative to the ground and z a vector in the unit disc,
///
///     f = n k u + c v + n^* q(|v|) z,    q(|v|) = q_fast - (q_fast - q_slow) exp(-rate |v|)
///     z' = v / u_y inside the disc; on its edge without the part of v that leads out of it
///
/// which is perfect plasticity with a circular yield surface. n = n^* = 1 + a_vertical / g >= 0 for
/// friction pendulums whose load follows the vertical motion, otherwise 1.
struct Isolation {
  std::string name;               ///< "lead rubber", "friction pendulum", "linear"
  double stiffness = 0;           ///< k >= 0 [1/s2]
  double viscosity = 0;           ///< c >= 0 [1/s]
  double slow_strength = 0;       ///< q_slow >= 0 [m/s2]
  double fast_strength = 0;       ///< q_fast >= 0 [m/s2]
  double strength_rate = 0;       ///< >= 0 [s/m]
  double yield_displacement = 1;  ///< u_y > 0 [m]
  bool follows_vertical = false;
  double base_mass_ratio =
      0;  ///< mass of the base floor over all that the layer carries, in (0, 1)
  double capacity = std::numeric_limits<double>::infinity();  ///< largest |u| with room [m]

  double strength(double speed) const;
};

/// Rubber with a viscous damper: k = (2 pi / T)^2, c = 2 zeta (2 pi / T).
/// @param period   > 0 [s]
/// @param damping  ratio >= 0
Isolation linear_isolation(double period, double damping);

/// Bilinear lead-rubber bearings.
/// @param period              of the rigid building on the post-yield stiffness > 0 [s]
/// @param strength_ratio      characteristic strength Q_d over weight > 0
/// @param yield_displacement  u_y > 0 [m]; the stiffness before yield is k + Q_d / u_y
/// @param damping             viscous ratio of the rubber at `period`, >= 0
Isolation lead_rubber(double period, double strength_ratio, double yield_displacement,
                      double damping);

/// Single friction pendulum, k = g / R, q = mu g (Zayas, Low & Mahin 1990, Earthquake Spectra 6(2),
/// 317-333), with the friction coefficient of Constantinou, Mokha & Reinhorn (1990), Journal of
/// Structural Engineering 116(2), 455-474:
///
///     mu = mu_fast - (mu_fast - mu_slow) exp(-rate |v|).
///
/// @param radius              of the sliding surface R > 0 [m]
/// @param slow, fast          friction coefficients, 0 <= slow <= fast
/// @param rate                >= 0 [s/m]
/// @param yield_displacement  shear of the liner before it slides > 0 [m]
Isolation friction_pendulum(double radius, double slow, double fast, double rate,
                            double yield_displacement);

/// Evolution of z while the base moves along a straight line.
struct Sliding {
  Vector2 end;   ///< z at the end
  Vector2 mean;  ///< mean of z over the increment
};

/// Exact: elastic up to the edge of the unit disc, then with psi the angle between z and the
/// increment, tan(psi / 2) falls by exp(-increment / u_y) (Krieg & Krieg 1977, Journal of Pressure
/// Vessel Technology 99(4), 510-515).
/// @param z    |z| <= 1
/// @param increment  displacement over u_y
Sliding slide(const Vector2& z, const Vector2& increment);

}  // namespace gurney::groundmotions
