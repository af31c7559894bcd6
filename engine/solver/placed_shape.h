#pragma once

#include "engine/contact/body_form.h"
#include "engine/scene/room.h"

namespace gurney {

/// A shape of the room as the search for contacts wants it, in floor axes.
BodyForm placed_shape(const RoomShape& room);

}  // namespace gurney
