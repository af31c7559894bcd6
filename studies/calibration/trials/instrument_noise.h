#pragma once

#include <cstdint>

#include "studies/calibration/trials/trial.h"

/// Synthetic noise of the instruments of a pulling test, for simulated signals.
namespace gurney::calibration {

/// Standard deviations. The motion capture of Xu, Ma & Kurata (2022, section 3.1) is accurate to
/// +-0.10 mm, which is taken as one; the noise of their load cell is not stated.
inline constexpr double kDisplacementNoise = 1e-4;  ///< [m]
inline constexpr double kForceNoise = 0.5;          ///< assumption [N]

/// The trial with normal noise on displacement, lateral displacement and force; independent from
/// sample to sample, the same for the same seed and stream.
Trial with_noise(Trial trial, std::uint64_t seed, std::uint64_t stream);

/// Rate of a series, by differences over four samples to either side, as a velocity is found from
/// measured positions; NaN at both ends.
std::vector<double> rate(const std::vector<double>& time, const std::vector<double>& series);

}  // namespace gurney::calibration
