#pragma once

#include <variant>

#include "engine/contact/column_points.h"
#include "engine/contact/convex_shape.h"
#include "engine/scene/room.h"

namespace gurney {

/// A shape of the room as the search for contacts wants it, in floor axes.
std::variant<ConvexShape, Cylinder> placed_shape(const RoomShape& room);

}  // namespace gurney
