#pragma once

#include <optional>

#include "engine/base/floor_motion.h"
#include "studies/report/fall.h"

namespace gurney::explanation {

/// The half cycle of a floor's motion that drives an item: of the rises of its velocity along
/// `direction` (horizontal, a unit vector) that end between `from` and `to`, or go on at `to`, the
/// largest. A rise goes from a turning point of the velocity to the next one; reversals below 20 %
/// of the range of the velocity, from 2 s before `from` to `to`, are none. What comes before and
/// after the acceleration has 1 % of its peak is cut off. None where it never rises by 1 mm/s.
std::optional<report::FloorPulse> driving_half_cycle(const FloorMotion& floor,
                                                     const Vector2& direction, double from,
                                                     double to);

}  // namespace gurney::explanation
