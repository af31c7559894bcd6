#pragma once

#include <cstdint>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

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
