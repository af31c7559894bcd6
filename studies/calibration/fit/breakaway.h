#pragma once

#include <string>

#include "studies/calibration/trials/trial.h"

/// Pulls that grow until something gives: start-up resistance, and friction of locked wheels.
namespace gurney::calibration {

/// Highest center of mass of an item on casters above the floor: an assumption; none of the catalogue
/// is above 1 m [m].
inline constexpr double kHighestCenter = 1.2;

/// Breakaway of one trial.
struct Breakaway {
  double peak = 0;           ///< start-up resistance over N, or mu_s
  bool peak_bounds = false;  ///< mu_s is `peak` or more
  double moving = 0;         ///< Cr / R, or mu_k
  double peak_error = 0, moving_error = 0;
  std::string moving_lost;  ///< why mu_k is not determined; empty: it is
};

/// The force over N at which it begins to move is that of find_onset(); in motion it is F - F_s -
/// (M + J) a between 5 % (one axle locked: 25 %) and 95 % of the path, J of the wheels that turn.
///
/// With all wheels locked the force in motion is mu_k N. The treads share the force before by their
/// stiffness and not by their load: the axle with less load breaks away first, drops to mu_k, jumps
/// and sticks again, so that the whole never reaches mu_s N. Between mu_s N and that force lies
/// all from 0 to twice (mu_s - mu_k) N_less (the jump overshoots by up to its own height): the
/// force is a lower bound.
///
/// With one axle locked both its wheels carry the same. Equilibrium of moments about the other
/// axle's line of contact gives its share s of N under the force F at the height h,
///
///     s = s_0 + (F h - M a h_cg) / (N L)  (rear: -),      mu = (x - (1 - s) Cr / R) / s
///
/// with x N the resistance, s_0 at rest, L the wheelbase, h_cg the height of the center of mass and
/// Cr / R of the wheels that roll. Where h_cg is not stated it is taken as h, and mu_k is not
/// determined where heights of 0 to kHighestCenter would change it by more than 1 %.
/// @throws UnusableTrial where it does not move, no 0.4 s are left, the force falls below half of its
///         mean while it moves, the motion is not that of Newton's law within a factor of 3, or a
///         share is not one of friction or rolling
Breakaway breakaway_of(const Trial& trial);

}  // namespace gurney::calibration
