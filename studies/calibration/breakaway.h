#pragma once

#include <optional>

#include "studies/trials/trial.h"

/// Pulls that grow until something gives: start-up resistance, and friction of locked wheels.
namespace gurney {

/// Of one trial, as shares of N.
struct Breakaway {
  double peak = 0;    ///< the largest force before it moves: start-up resistance, or mu_s
  double moving = 0;  ///< mean while it moves, its acceleration taken off: Cr / R, or mu_k
  double peak_error = 0, moving_error = 0;
  double moved_at = 0;  ///< [s]
};

/// The peak is the largest F - F_s - (M + J) a, J = 0 of locked wheels, with F and a from the mean
/// and a quadratic over 0.2 s (0.4 s where wheels roll, as their force is small), until it has
/// moved 5 % of its path. It moves from there to 95 % of its path, where the same is done once.
/// @return nothing, and a fault in `fault`, where it does not move, no 0.4 s are left, or the
///         force falls below half of its mean while it moves
std::optional<Breakaway> breakaway_of(const Trial& trial, TrialFault& fault);

}  // namespace gurney
