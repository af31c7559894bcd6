#pragma once

#include <Eigen/Core>
#include <optional>

namespace gurney::groundmotions {

/// A zero-phase Butterworth filter: high-pass, low-pass, or both one after the other (band-pass).
/// It runs forward and backward, so its gain is the square of that of one pass. With n the order,
///
///     |H(f)| = 1 / (1 + (f_hp / f)^2n)  *  1 / (1 + (f / f_lp)^2n)
///
/// which is 1/2 (-6 dB, not -3 dB) at a corner; the corner is not moved to make up for the second
/// pass. A pass is a chain of second-order sections by the bilinear transform, prewarped so that
/// the corner is exact: in the formula f stands for tan(pi f h).
///
/// Before, the record is tapered at both ends and zeros are added, 1.5 n / f_c seconds at each end
/// with f_c the lowest corner (Converse & Brady 1992, USGS Open-File Report 92-296A; Boore & Bommer
/// 2005, Soil Dynamics and Earthquake Engineering 25, 93-115). The tail of the filter in the pads
/// is part of the motion: without it velocity and displacement do not come back to zero (Boore
/// 2005, BSSA 95(2), 745-750).
struct Butterworth {
  std::optional<double> high_pass;  ///< corner f_hp > 0; what is below goes [Hz]
  std::optional<double> low_pass;   ///< corner f_lp > f_hp, below the Nyquist frequency [Hz]
  int order = 4;                    ///< n of one pass, 1..10
  bool keep_pads = true;            ///< the result is longer by 2 pad_samples()
  std::optional<double> taper;      ///< at each end of the record, >= 0; none: 1 % of it [s]
};

inline constexpr int kHighestOrder = 10;

/// Taper of the record for a filter that does not say: an assumption, share of the record.
inline constexpr double kFilterTaper = 0.01;

/// Zeros added at each end.
/// @throws Error for a corner that is not > 0 or not below the Nyquist frequency 1 / (2 h), corners
///         in the wrong order, no corner, an order outside 1..10, more than 10 million samples.
Eigen::Index pad_samples(const Butterworth& filter, double time_step);

/// @param time_step     h > 0 [s]
/// @param acceleration  at least 2 samples
/// @returns the filtered samples; with keep_pads the first one is pad_samples() steps earlier.
/// @throws Error as pad_samples(), and as tapered().
Eigen::VectorXd filtered(const Butterworth& filter, double time_step,
                         const Eigen::VectorXd& acceleration);

}  // namespace gurney::groundmotions
