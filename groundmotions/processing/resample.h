#pragma once

#include <Eigen/Core>

namespace gurney::groundmotions {

/// The same motion at another time step, whole or not a multiple of the old one: band-limited
/// interpolation by a sinc under a Kaiser window (Kaiser 1974, IEEE Int. Symp. Circuits and
/// Systems, 20-23) of 100 dB, beta = 10.06. f_N is a Nyquist frequency.
///
/// Finer steps: the sinc has its zeros at the old samples and spans 33 of them to each side; old
/// samples are kept where a new one falls on them. Gain 1 +- 1e-5 up to 0.9 f_N of the old step;
/// what is above leaves images between 1 and 1.1 f_N.
/// Coarser steps: the same kernel is the anti-alias filter, -6 dB at 0.95 f_N of the new step, 65
/// new steps to each side. Gain 1 +- 1e-5 up to 0.9 f_N, below 1e-5 from f_N on.
///
/// A constant is kept exactly; outside the record the motion is zero, so an offset or a jump at an
/// end rings there over the span of the kernel: correct the baseline first.
///
/// @param time_step      > 0 [s]
/// @param new_time_step  > 0 [s]
/// @returns the samples at 0, h, 2 h ... not beyond the last old one: floor(duration / h) + 1
/// @throws Error unless new_time_step > 0 gives 2 to 10 million samples.
Eigen::VectorXd resampled(double time_step, const Eigen::VectorXd& acceleration,
                          double new_time_step);

}  // namespace gurney::groundmotions
