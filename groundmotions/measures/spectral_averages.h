#pragma once

#include <Eigen/Core>

namespace gurney::groundmotions {

/// The periods of SaAvg(T): 0.01 s apart from 0.2 T to 3 T, as Eads, Miranda & Lignos (2015, EESD
/// 44(12), 2057-2073) have them; at least ten, then evenly spaced.
/// @param period  > 0 [s]
Eigen::VectorXd average_periods(double period);

/// Periods between two periods 0 < from < to [s].
Eigen::VectorXd average_periods(double from, double to);

/// Average spectral acceleration: the geometric mean of `spectral_accelerations` [m/s2], 0 if one
/// of them is 0.
double geometric_mean(const Eigen::VectorXd& spectral_accelerations);

/// Spectrum intensity SI = int_0.1^2.5 PSV dT [m] (Housner 1952, Spectrum intensities of
/// strong-motion earthquakes, Proc. Symposium on Earthquake and Blast Effects on Structures, Los
/// Angeles), here at 5 % damping, peaks at the samples, by the trapezoid in steps of 0.02 s
/// (damping and step are assumptions).
double spectrum_intensity(double time_step, const Eigen::VectorXd& acceleration);

}  // namespace gurney::groundmotions
