#pragma once

#include <Eigen/Core>

namespace gurney {

/// Filtered incremental velocity FIV3 of a period T (Davalos & Miranda 2019, Earthquake Engineering
/// and Structural Dynamics 48(12), 1384-1405): the acceleration passes a second-order Butterworth
/// low-pass with its corner at 0.85 / T, once and forward; the incremental velocity is the integral
/// of the result over a window of 0.7 T that starts at each sample (trapezoidal rule; its length is
/// rounded to whole steps). FIV3 is the larger of the sum of the three highest peaks of it and the
/// absolute sum of its three lowest troughs. Peaks below zero and troughs above zero do not count.
///
/// That the filter runs forward only is how public implementations read the paper; with a corner at
/// or above the Nyquist frequency the acceleration is not filtered.
///
/// @param time_step  > 0 [s]
/// @param period     T > 0, longer than the time step [s]
/// @returns [m/s]; 0 for a record shorter than the window
/// @throws Error for another period.
double fiv3(double time_step, const Eigen::VectorXd& acceleration, double period);

}  // namespace gurney
