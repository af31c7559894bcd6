#pragma once

#include "studies/calibration/fit/rebound.h"

namespace gurney::calibration {

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
