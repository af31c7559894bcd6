#pragma once

#include <Eigen/Core>
#include <string>

namespace gurney::groundmotions {

/// Where the peak of an oscillator's response is looked for.
enum class PeakAt {
  /// At the samples of the record, as PEER's NGA-West2 spectra are. Misses at most
  /// (pi dt / T)^2 / 2 (PSA + PGA) of PSA.
  kSamples,
  /// On a grid of at most T/200, which misses at most 1.3e-4 (PSA + PGA), and through two periods
  /// of free vibration after the end of the record.
  kBetweenSamples
};

/// Elastic response spectra of one component. "Sa" is the pseudo-acceleration everywhere in Gurney.
struct ResponseSpectrum {
  Eigen::VectorXd period;                 ///< T as asked for [s]
  Eigen::VectorXd displacement;           ///< SD = max |u|, relative to the ground [m]
  Eigen::VectorXd pseudo_velocity;        ///< PSV = (2 pi / T) SD [m/s]
  Eigen::VectorXd pseudo_acceleration;    ///< PSA = (2 pi / T)^2 SD [m/s2]
  Eigen::VectorXd absolute_acceleration;  ///< max |u'' + a| = max |2 zeta omega u' + omega^2 u|
};

/// The largest response of oscillators u'' + 2 zeta omega u' + omega^2 u = -a, omega = 2 pi / T, at
/// rest at the first sample. The solution is exact for an acceleration that is linear between its
/// samples (Nigam & Jennings 1969, BSSA 59(2), 909-922) and stable for any T; T = 0 gives SD = PSV
/// = 0 and PSA = PGA.
///
/// @param time_step     > 0 [s]
/// @param acceleration  [m/s2]; empty: all spectra are zero
/// @param periods       [s], each >= 0, in any order
/// @param damping       zeta in [0, 1)
/// @throws Error for a period or a damping out of range.
ResponseSpectrum response_spectrum(double time_step, const Eigen::VectorXd& acceleration,
                                   const Eigen::VectorXd& periods, double damping = 0.05,
                                   PeakAt peak_at = PeakAt::kSamples);

/// A warning for a period between 0 and 10 dt, where what the motion does between its samples
/// matters; empty for other periods.
std::string short_period_warning(double time_step, double period);

/// `count` periods from `first` to `last`, evenly spaced in their logarithm.
/// @param first  > 0
Eigen::VectorXd logarithmic_periods(double first, double last, int count);

}  // namespace gurney::groundmotions
