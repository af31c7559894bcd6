#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// Stationary Gaussian noise with a chosen Fourier amplitude: a sum of cosines at the frequencies
/// f_k = k / (n dt), n the next power of two,
///
///     x(t) = sum_k A(f_k) (u_k cos(2 pi f_k t) + v_k sin(2 pi f_k t)),
///
/// u_k, v_k independent standard normal numbers (normal_draw.h). The same draws under another A
/// keep their phases.
class FourierNoise {
 public:
  /// @param stream  noise of different streams is independent
  FourierNoise(std::uint64_t seed, std::uint64_t stream, Eigen::Index samples, double time_step);

  /// @param amplitude  A(f), f > 0 [Hz]
  Eigen::VectorXd shaped(const std::function<double(double)>& amplitude) const;

  /// The acceleration A(f) under an envelope that multiplies its displacement, that of A / omega^2.
  /// @param envelope  smooth, with its slope 0 at both ends
  Eigen::VectorXd acceleration(const std::function<double(double)>& amplitude,
                               const Eigen::VectorXd& envelope) const;

 private:
  Eigen::Index samples_;
  double time_step_;
  Eigen::VectorXcd draws_;  ///< u_k - i v_k, k = 0 .. n/2
};

/// White noise between two frequencies, up to three independent components.
struct WhiteNoise {
  std::uint64_t seed = 0;
  double lowest_frequency = 0, highest_frequency = 0;  ///< 0 < lowest < highest [Hz]
  double duration = 0;                                 ///< with tapers > 0 [s]
  double taper = 0;                                    ///< of each end, sin^2, > 0 [s]
  double peak_acceleration[3] = {0, 0, 0};             ///< by Direction; 0: no such component
};

/// Noise whose displacement is tapered, so that it has no drift and ends at rest where it began
/// (component.h), scaled to its peak at samples.
/// @throws Error unless the band lies below 0.4 of the sampling rate and the taper fits.
Record white_noise(double time_step, const WhiteNoise& motion);

}  // namespace gurney::groundmotions
