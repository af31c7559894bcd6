#pragma once

#include <Eigen/Core>

namespace gurney {

/// Integral measures of one component. All integrals are by the trapezoidal rule over the samples;
/// for a piecewise-linear acceleration that is exact for the Arias integral only in the limit of
/// small steps.

/// Arias intensity pi / (2 g) * integral of a^2 dt, g the standard gravity (Arias 1970, in: Seismic
/// Design for Nuclear Power Plants, MIT Press, 438-483) [m/s].
double arias_intensity(double time_step, const Eigen::VectorXd& acceleration);

/// Cumulative absolute velocity, the integral of |a| dt (EPRI NP-5930, 1988) [m/s].
double cumulative_absolute_velocity(double time_step, const Eigen::VectorXd& acceleration);

/// Time in which the Husid curve, the running integral of a^2 over its end value, grows from one
/// share to another, linear between samples: 0.05 to 0.95 gives D5-95, 0.05 to 0.75 D5-75
/// (Trifunac & Brady 1975, BSSA 65(3), 581-626) [s]. 0 for a motion that is all zero.
/// @param from, to  0 <= from < to <= 1
double significant_duration(double time_step, const Eigen::VectorXd& acceleration, double from,
                            double to);

/// Mean period sum(C^2 / f) / sum(C^2) over the Fourier amplitudes C at frequencies f of 0.25 to 20
/// Hz (Rathje, Abrahamson & Bray 1998, J. Geotech. Geoenviron. Eng. 124(2), 150-159; spacing of at
/// most 0.05 Hz as in Rathje et al. 2004, Earthquake Spectra 20(1), 119-144). The record is filled
/// with zeros to the next power of two that gives this spacing [s]. 0 for a motion that is all
/// zero there.
double mean_period(double time_step, const Eigen::VectorXd& acceleration);

}  // namespace gurney
