#pragma once

#include <optional>

#include "studies/calibration/trials/polynomial_fit.h"
#include "studies/calibration/trials/trial.h"

namespace gurney::calibration {

/// Newton's law between a force and a motion that were measured apart.
struct MotionLaw {
  double scale = 1, scale_error = 0;  ///< s: motion over what force and mass make of it
  double lag = 0;                     ///< of the force's clock behind the motion's, or 0 [s]
};

/// While it moves against a constant resistance R,
///
///     x(t) = x_0 + v_0 t + s / M (int int F(t + lag) dt dt - R t^2 / 2)
///
/// Least squares in x_0, v_0, s and s R for every lag within 0.3 s. `lag` is the best one with s
/// within a factor of 3 from 1, where the sum of squares without any is larger by more than 50
/// variances, and it is more than 0.05 s; 0 elsewhere, as where the force hardly changes and
/// determines nothing. s is that without a lag.
/// @return nothing where `span` has less than 24 samples
std::optional<MotionLaw> motion_law(const TrialSignals& signals, const Span& span, double inertia);

}  // namespace gurney::calibration
