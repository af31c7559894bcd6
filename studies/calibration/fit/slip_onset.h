#pragma once

#include <optional>

#include "studies/calibration/trials/polynomial_fit.h"
#include "studies/calibration/trials/trial.h"

namespace gurney::calibration {

/// When an item that is pulled ever harder begins to move, and by which force.
struct SlipOnset {
  double time = 0;                    ///< [s]
  double force = 0, force_error = 0;  ///< of the cable at that time, and its standard error [N]
};

/// Newton's law from the onset t_b on, with the measured force F and the resistance R in motion:
///
///     x(t) = x_b + v (t - t_b) + s int_{t_b}^t int_{t_b}^t' (F - R) / M dt'' dt',     s = 1
///
/// Least squares over `window` for every t_b on a grid of 1 ms; x_b and v (treads wind up) follow
/// linearly. F at t_b is a line through the 0.3 s before. Its error holds that of the line, the
/// line's slope times half of the range of t_b where the sum of squares is within one variance of
/// the least (a profile likelihood: Venzon & Moolgavkar 1988, Applied Statistics 37(1), 87-94), and
/// what `resisting_error` shifts.
///
/// A peak is no estimate of this force: the largest of noisy means is high, a mean over a rising
/// force low, and a winch pulls harder yet while the item gathers speed.
/// @param free  s is not 1: what accelerates the item loads or unloads the wheels that resist, in
///              proportion
/// @param window  0.6 s and more; the onset is found from 0.3 s after its begin on
/// @return nothing where the window is shorter
std::optional<SlipOnset> find_onset(const TrialSignals& signals, const Span& window, double inertia,
                                    double resisting, double resisting_error, bool free);

}  // namespace gurney::calibration
