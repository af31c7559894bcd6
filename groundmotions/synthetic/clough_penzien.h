#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// One component of a synthetic motion.
struct SyntheticComponent {
  double peak_acceleration = 0;  ///< of the finished component > 0 [m/s2]
  double peak_time = 6;          ///< t_p of the envelope > 0 [s]
  double envelope_power = 3;     ///< p of the envelope > 0 [-]
  double ground_frequency = 0;   ///< omega_g > 0 [rad/s]
  double ground_damping = 0.6;   ///< zeta_g in [0, 1)
  double low_cut_frequency = 0;  ///< omega_f > 0 [rad/s]
  double low_cut_damping = 0.6;  ///< zeta_f in [0, 1)
};

/// A stochastic three-component motion; docs/theory/synthetic_record.md.
struct SyntheticMotion {
  std::uint64_t seed = 0;
  double time_step = 0.005;                      ///< > 0 [s]
  int samples = 0;                               ///< > 2
  std::array<SyntheticComponent, 3> components;  ///< indexed by Direction
};

/// White noise under an envelope through the Kanai-Tajimi and Clough-Penzien filters:
///
///     w(t)  = e(t) n(t),  e(t) = ((t / t_p) exp(1 - t / t_p))^p       (Saragoni & Hart 1974)
///     x'' + 2 zeta_g omega_g x' + omega_g^2 x = -w
///     b     = -2 zeta_g omega_g x' - omega_g^2 x                      (Kanai 1957, Tajimi 1960)
///     z'' + 2 zeta_f omega_f z' + omega_f^2 z = -b,  a = z''          (Clough & Penzien 1975)
///
/// n(t) is linear between independent standard normal values at the samples. Then
/// c_1 s^2 + c_2 s^2 cos(pi t / T), s = sin(pi t / T), is taken off a so that velocity and
/// displacement end at zero, and a is scaled to its peak. Correlation between components is not
/// modelled.
Record synthetic_record(const SyntheticMotion& motion);

/// The z'' of one component as the filters leave it: neither scaled nor made to end at rest.
Eigen::VectorXd clough_penzien_noise(const SyntheticMotion& motion, Direction direction);

/// The motion of groundmotions/records/synthetic_3c.csv.
SyntheticMotion shipped_synthetic_motion();

/// The whole text of groundmotions/records/synthetic_3c.csv.
std::string shipped_synthetic_text();

/// A long motion of long period, as deep basins make it: Clough-Penzien noise (clough_penzien.h)
/// with a ground of a few seconds' period and low damping. The displacement is tapered over the
/// first and the last tenth (sin^2), so that it ends at rest where it began; two horizontals are
/// scaled to their peak velocity.
struct LongPeriodMotion {
  std::uint64_t seed = 0;
  double time_step = 0.01;       ///< > 0 [s]
  double duration = 300;         ///< > 0 [s]
  double peak_velocity[2] = {};  ///< of h1 and h2, 0: no such component [m/s]
  double ground_period = 4;      ///< 2 pi / omega_g > 0 [s]
  double ground_damping = 0.15;  ///< zeta_g in (0, 1)
  double low_cut_period = 12;    ///< 2 pi / omega_f > 0 [s]
  double peak_time = 80;         ///< t_p of the envelope > 0 [s]
  double envelope_power = 1.5;   ///< p of the envelope > 0 [-]
};

/// @throws Error without a component.
Record long_period_motion(const LongPeriodMotion& motion);

}  // namespace gurney::groundmotions
