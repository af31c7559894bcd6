#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// Required response spectrum of ICC-ES AC156, Acceptance Criteria for Seismic Certification by
/// Shake-Table Testing of Nonstructural Components (2010), 5 % of critical damping:
///
///     A_FLX-H = S_DS (1 + 2 z/h) <= 1.6 S_DS     A_RIG-H = 0.4 S_DS (1 + 2 z/h)
///     A_FLX-V = 0.67 S_DS                        A_RIG-V = 0.27 S_DS
///
/// A_FLX from 1.3 to 8.3 Hz, straight in logarithms to A_RIG at 33.3 Hz and A_RIG above it. Below
/// 1.3 Hz the document draws a straight branch and gives no number: 0.1 A_FLX at 0.1 Hz is read
/// off, and nothing below 1.3 Hz is held against it.
struct RequiredSpectrum {
  double flexible = 0;  ///< A_FLX [m/s2]
  double rigid = 0;     ///< A_RIG [m/s2]

  double at(double frequency) const;  ///< frequency > 0 [Hz]; [m/s2]
};

inline constexpr double kAc156Lowest = 1.3, kAc156Corner = 8.3, kAc156Highest = 33.3;  ///< [Hz]

/// @param short_period_acceleration  S_DS > 0 [m/s2]
/// @param height_ratio               z/h in [0, 1]
RequiredSpectrum required_horizontal(double short_period_acceleration, double height_ratio);
RequiredSpectrum required_vertical(double short_period_acceleration);

/// The frequencies at which AC156 compares: from 1.3 Hz in steps of 1 / per_octave octave, and
/// 33.3 Hz [Hz].
std::vector<double> ac156_frequencies(int per_octave = 6);

/// A three-component floor motion that fits the required spectrum.
struct Ac156Motion {
  std::uint64_t seed = 0;
  double time_step = 0.002;                ///< > 0, at most 0.005 [s]
  double short_period_acceleration = 0;    ///< S_DS > 0 [m/s2]
  double height_ratio = 0;                 ///< z/h in [0, 1]
  double build = 5, hold = 20, decay = 5;  ///< envelope, AC156's values [s]
  double low_cut = 0.9;                    ///< no energy below, in [0.3, 1.1] [Hz]
};

/// Stationary noise (noise.h) under a build-hold-decay envelope with sin^2 ramps on its
/// displacement, so that it ends at rest where it began. Its Fourier amplitudes are multiplied
/// again and again by the ratio of the required to the motion's spectrum, phases kept (Gasparini &
/// Vanmarcke 1976, MIT report R76-4, SIMQKE), on a grid of 24 frequencies an octave from 1.3
/// to 33.3 Hz. The best of these is scaled so that it envelopes the required spectrum at every
/// frequency in this range: its smallest ratio is 1.005 at 768 points an octave, and halfway
/// between two of these a spectrum of 5 % cannot be more than 0.0045 lower. The tolerances of AC156
/// for single points are not used. Components of different streams; streams are skipped, 20 at most
/// for a component, until all correlations are below 0.3.
///
/// The header states the largest and smallest ratio to the required spectrum and the correlations;
/// more than 30 % above it between 1.3 and 8.3 Hz, the most that AC156 recommends, is a warning.
/// @throws Error for a time step above 0.005 s, and if no stream is independent of the others.
Record ac156_motion(const Ac156Motion& motion);

}  // namespace gurney::groundmotions
