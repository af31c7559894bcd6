#pragma once

#include <vector>

#include "engine/base/floor_motion.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// The floor motion that a record is, scaled and turned about the vertical. With f the scale and
/// theta the angle,
///
///     a_x = f (cos(theta) a_h1 - sin(theta) a_h2)
///     a_y = f (sin(theta) a_h1 + cos(theta) a_h2)
///     a_z = f a_vertical
///
/// and a rotation of the floor likewise.
///
/// @param scale  > 0
/// @param angle  of the direction of h1 from the x axis of the item at its start,
///               counter-clockwise seen from above [rad]
/// @param use    the components to use, the others are at rest; empty: all that the record has
/// @throws Error unless scale > 0 and the angle is finite, for a component that the record does not
///         have, and for a record without components.
FloorMotion floor_motion(const Record& record, double scale = 1, double angle = 0,
                         const std::vector<Direction>& use = {});

}  // namespace gurney::groundmotions
