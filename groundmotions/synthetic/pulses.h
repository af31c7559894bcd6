#pragma once

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

// Simple pulses, h1 only, sampled from closed forms. Those that cannot end at rest where they began
// say so in a warning.

/// a = A sin(2 pi t / T) for half a period T. Leaves the velocity A T / pi.
Record half_sine(double time_step, double peak_acceleration, double period);

/// a = A sin(2 pi t / T) for one period: a step of A T^2 / (2 pi) in displacement (fling step),
/// peak velocity A T / pi.
Record full_sine(double time_step, double peak_acceleration, double period);

/// Constant acceleration A for `hold`, with linear ramps of `rise` before and after it. Leaves the
/// velocity A (hold + rise).
Record acceleration_step(double time_step, double peak_acceleration, double rise, double hold);

/// Two opposite half sines of acceleration, each changes the velocity by V in `width`, their
/// middles apart by `interval` >= width: the floor moves at V in between and is left at
/// V interval. A smooth form of the double impulse of Kojima & Takewaki (2015), Frontiers in Built
/// Environment 1:12. Peak acceleration pi V / (2 width).
/// @throws Error unless interval >= width.
Record double_impulse(double time_step, double velocity, double width, double interval);

/// Ricker wavelet (Ricker 1943, BSSA 33(3), 197-228) as acceleration, with tau = t - 1.5 T and
/// f = 1 / T: a = A (1 - 2 pi^2 f^2 tau^2) exp(-pi^2 f^2 tau^2) for 3 T. Its Fourier amplitude is
/// largest at f; peak velocity A T / (pi sqrt(2 e)).
Record ricker_wavelet(double time_step, double peak_acceleration, double period);

/// Near-fault velocity pulse of Mavroeidis & Papageorgiou (2003), BSSA 93(3), 1099-1131, with
/// tau = t - gamma / (2 f_p):
///
///     v = A/2 (1 + cos(2 pi f_p tau / gamma)) cos(2 pi f_p tau + nu),  |tau| <= gamma / (2 f_p)
///     a = -A pi f_p / gamma (sin(2 pi f_p tau / gamma) cos(2 pi f_p tau + nu)
///         + gamma sin(2 pi f_p tau + nu) (1 + cos(2 pi f_p tau / gamma)))
///     d_end = A cos(nu) sin(pi gamma) / (2 pi f_p (1 - gamma^2))
///
/// It comes back for nu = +-90 degrees and for whole gamma.
struct NearFaultPulse {
  double amplitude = 0;  ///< A > 0, the peak velocity for nu = 0 [m/s]
  double period = 0;     ///< 1 / f_p > 0 [s]
  double gamma = 0;      ///< > 1 [-]
  double phase = 0;      ///< nu [rad]
};
Record near_fault_pulse(double time_step, const NearFaultPulse& pulse);

/// The record with the pulse added to h1 from the sample nearest to `start` on.
/// @throws Error where the pulse ends after the record
Record with_pulse(Record record, const NearFaultPulse& pulse, double start);

}  // namespace gurney::groundmotions
