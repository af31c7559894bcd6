#pragma once

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

// Sines of constant or changing frequency, h1 only. Their displacement is what is tapered,
//
//     d = -A w(t) sin(phi) / phi'^2,  w = 1, at the ends sin^2 over the taper,
//
// so that they have no drift and end at rest where they began; a = d'' (component.h) is
// A w sin(phi) but for terms that are small while w and phi' change slowly. Then a is scaled to its
// peak A at samples.

/// phi = 2 pi f t.
struct Harmonic {
  double peak_acceleration = 0;  ///< A > 0 [m/s2]
  double frequency = 0;          ///< f > 0 [Hz]
  double duration = 0;           ///< with tapers > 0 [s]
  double taper = 0;              ///< of each end, in (0, duration / 2] [s]
};

/// @throws Error unless f is below a fifth of the sampling rate and the taper fits.
Record harmonic(double time_step, const Harmonic& motion);

/// a = A w(t) sin(phi), the frequency phi' / (2 pi) goes from f_0 to f_1 in time T, with r =
/// f_1/f_0
///
///     linear:       phi = 2 pi (f_0 t + (f_1 - f_0) t^2 / (2 T))
///     logarithmic:  phi = 2 pi f_0 T / ln(r) (r^(t/T) - 1)
struct Sweep {
  double peak_acceleration = 0;  ///< A > 0 [m/s2]
  double first_frequency = 0;    ///< f_0 > 0 [Hz]
  double last_frequency = 0;     ///< f_1 > 0, not f_0 if logarithmic [Hz]
  double duration = 0;           ///< T, with tapers > 0 [s]
  double taper = 0;              ///< of each end, in (0, duration / 2] [s]
  bool logarithmic = false;
};

/// @throws Error like harmonic().
Record sweep(double time_step, const Sweep& motion);

}  // namespace gurney::groundmotions
