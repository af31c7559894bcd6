#pragma once

#include <Eigen/Core>

namespace gurney::groundmotions {

/// The constants of FIV3. Those of Davalos & Miranda (2019); they could be checked against public
/// programs only, not against the paper.
struct Fiv3Settings {
  double window = 0.7;   ///< alpha: length of the window over T > 0
  double cutoff = 0.85;  ///< beta: corner of the low-pass filter times T > 0
};

/// Filtered incremental velocity (Davalos & Miranda 2019, EESD 48(12), 1384-1405):
///
///     V(t) = integral of a_f from t to t + alpha T
///     FIV3 = max(sum of the three highest maxima of V, |sum of the three lowest minima of V|)
///
/// a_f is the acceleration through a low-pass Butterworth filter of second order with the corner
/// beta / T. Assumed, as the definition leaves it open: the filter runs forward and backward, so it
/// shifts nothing; before and after the record the ground is at rest; a_f is linear between its
/// samples; windows start at the samples and lie within the record; maxima are local, inside the
/// record and above zero, minima likewise below zero, and fewer than three are summed as they are.
///
/// @param time_step     > 0 [s]
/// @param acceleration  [m/s2]
/// @param period        T > 0 [s]
/// @returns             [m/s]
/// @throws Error if T is out of range: the window longer than the record, or the corner not below
///         the Nyquist frequency.
double fiv3(double time_step, const Eigen::VectorXd& acceleration, double period,
            const Fiv3Settings& settings = {});

}  // namespace gurney::groundmotions
