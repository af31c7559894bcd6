#pragma once

#include <Eigen/Core>

namespace gurney::groundmotions {

/// Mean period Tm = sum(C_i^2 / f_i) / sum(C_i^2) over 0.25 Hz <= f_i <= 20 Hz [s], C_i the Fourier
/// amplitudes (Rathje, Abrahamson & Bray 1998, J. Geotech. Geoenviron. Eng. 124(2), 150-159;
/// Rathje, Faraj, Russell & Bray 2004, Earthquake Spectra 20(1), 119-144, who ask for a frequency
/// step of at most 0.05 Hz). The record is padded with zeros to a power of two of at least twice
/// its length and at least 20 s. 0 if there is nothing in this band.
/// @param time_step     > 0 [s]
/// @param acceleration  [m/s2]
double mean_period(double time_step, const Eigen::VectorXd& acceleration);

/// Predominant period Tp: where PSA at 5 % damping (at the samples) is largest [s] (Rathje et al.
/// 1998), among 400 logarithmically spaced periods from 0.02 to 10 s, which are 1.6 % apart. The
/// shortest of equals; 0 for a motion that is all zero.
double predominant_period(double time_step, const Eigen::VectorXd& acceleration);

}  // namespace gurney::groundmotions
