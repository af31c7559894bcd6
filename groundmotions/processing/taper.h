#pragma once

#include <Eigen/Core>

namespace gurney::groundmotions {

/// Cosine tapers (Hann): the samples of the first `start` seconds times (1 - cos(pi t / start)) /
/// 2, with t the time since the first sample, and likewise those of the last `end` seconds
/// backwards. The end samples become zero.
/// @param time_step   > 0 [s]
/// @param start, end  >= 0, together at most the duration; 0: no taper there [s]
/// @throws Error for other lengths.
Eigen::VectorXd tapered(double time_step, const Eigen::VectorXd& acceleration, double start,
                        double end);

}  // namespace gurney::groundmotions
