#pragma once

#include <Eigen/Core>

namespace gurney {

/// Where the peak of a response is looked for.
enum class PeakAt {
  /// At the samples of the record. What most programs give; for periods below some ten time steps
  /// it is too low, by up to 50 % near two time steps.
  kSamples,
  /// Between the samples as well, at least 200 times in a period, and during two periods after the
  /// end of the record: within 0.013 % of the peak of the piecewise-linear record.
  kBetweenSamples
};

/// Peak responses of damped linear oscillators, one for each period.
struct ResponseSpectrum {
  Eigen::VectorXd period;                 ///< [s]
  Eigen::VectorXd displacement;           ///< SD, largest |u| [m]
  Eigen::VectorXd pseudo_acceleration;    ///< PSA = (2 pi / T)^2 SD; Sa in this program [m/s2]
  Eigen::VectorXd absolute_acceleration;  ///< largest |u'' + a| = |2 zeta omega u' + omega^2 u|
};

/// The response to a ground acceleration that is linear between its samples, from rest: exact from
/// sample to sample (Nigam & Jennings 1969, BSSA 59(2), 909-922), so that no time step is too long
/// for the solution. At T = 0 the oscillator is rigid: SD is 0, both accelerations are PGA.
///
/// @param time_step     > 0 [s]
/// @param acceleration  of the ground [m/s2]
/// @param periods       T >= 0 [s]
/// @param damping       zeta in [0, 1)
/// @throws Error for values outside these ranges.
ResponseSpectrum response_spectrum(double time_step, const Eigen::VectorXd& acceleration,
                                   const Eigen::VectorXd& periods, double damping = 0.05,
                                   PeakAt peak_at = PeakAt::kSamples);

/// Relative displacement of one oscillator at the samples [m]. @param period  > 0 [s]
Eigen::VectorXd oscillator_displacement(double time_step, const Eigen::VectorXd& acceleration,
                                        double period, double damping = 0.05);

}  // namespace gurney
