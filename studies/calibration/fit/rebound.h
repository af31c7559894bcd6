#pragma once

#include "studies/calibration/trials/trial.h"

namespace gurney::calibration {

/// Rebound of one impact.
struct Rebound {
  double approach = 0, leaving = 0;  ///< speeds at the impact, > 0 [m/s]
  double slowing = 0;                ///< deceleration before [m/s2]
  double restitution = 0;            ///< e
  double error = 0;                  ///< standard error of e
  double time = 0;                   ///< of the impact [s]
};

/// The impact is where the displacement is largest. Quadratics over 0.25 s on either side, 0.03 s
/// away from it, give the speeds at that time. e is leaving / approach, or that of
/// contact_restitution() where the trial names its item.
/// @throws UnusableTrial where the record is too short on one side, the approach is not within 0.02 to
///         5 m/s, it slows down by more than 1 m/s2 (a Cr / R of 0.1), e is not within (0, 1], or the
///         item is not known
Rebound rebound_of(const Trial& trial);

/// e of the contact and d e / d (leaving / approach).
struct ContactRestitution {
  double value = 0, slope = 1;
};

/// The e of item and wall with which the engine's item rebounds from a wall as fast as it was
/// measured, by the method of secants. The ratio of the speeds is not e itself: the wall meets the
/// item's face above its centre of mass, so that it pitches, and the wheels are turned round.
/// @param rebound  its ratio of speeds is met within 1e-4
/// @throws Error where the catalogue does not know the item, or no e in 0.01..1 does it
ContactRestitution contact_restitution(const Trial& trial, const Rebound& rebound);

}  // namespace gurney::calibration
