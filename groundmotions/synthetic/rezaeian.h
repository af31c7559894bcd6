#pragma once

#include <cstdint>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// Fully non-stationary filtered white noise of Rezaeian & Der Kiureghian (2010), Earthquake
/// Engineering and Structural Dynamics 39(10), 1155-1180, one set of parameters for each component:
///
///     x(t)    = q(t) / sigma_h(t) sum_i h(t - t_i; t_i) u_i,   sigma_h^2 = sum_i h^2
///     h(s; t) = omega_f / sqrt(1 - zeta^2) exp(-zeta omega_f s) sin(omega_f sqrt(1 - zeta^2) s)
///     omega_f = omega_mid + omega' (t - t_mid)
///     q(t)^2  = 2 g I_a / pi times the gamma density with D_5-95 and t_45 = t_mid
///     z'' + 2 omega_c z' + omega_c^2 z = x,  a = z''
///
/// I_a, D_5-95 and t_mid are those of the expected energy of x; a single motion scatters about
/// them, and the high-pass takes off what lies below its corner.
struct StochasticComponent {
  double arias_intensity = 0;  ///< I_a >= 0, 0: no such component [m/s]
  double duration = 0;         ///< D_5-95 > 0 [s]
  double middle = 0;           ///< t_mid > 0: 45 % of the energy has come [s]
  double frequency = 0;        ///< omega_mid / (2 pi) > 0 [Hz]
  double frequency_slope = 0;  ///< omega' / (2 pi) [Hz/s]
  double damping = 0;          ///< zeta in (0, 1)
};

struct StochasticMotion {
  std::uint64_t seed = 0;
  double time_step = 0.005;           ///< > 0 [s]
  double corner_frequency = 0;        ///< omega_c / (2 pi) > 0 [Hz]
  StochasticComponent components[3];  ///< by Direction; independent noise
};

/// omega_f is held between 0.3 Hz and half the Nyquist frequency (an assumption). The motion runs
/// until 99.9 % of the energy has come and 2 / corner frequency longer, then its end state is set
/// to rest (component.h).
/// @throws Error unless D_5-95 < 4.5 t_mid, where the gamma density has no singularity at 0, and
///         omega_mid is below half the Nyquist frequency.
Record stochastic_motion(const StochasticMotion& motion);

/// Parameters of q: q^2 = E b^k t^(k-1) exp(-b t) / Gamma(k), the energy E left out.
struct GammaEnvelope {
  double shape = 0;  ///< k = 2 alpha_2 - 1 of the paper [-]
  double rate = 0;   ///< b = 2 alpha_3 [1/s]
};

/// The gamma density with t_95 - t_5 = duration and t_45 = middle.
GammaEnvelope gamma_envelope(double duration, double middle);

/// Time at which the share `probability` of the energy has come.
double gamma_time(const GammaEnvelope& envelope, double probability);

}  // namespace gurney::groundmotions
