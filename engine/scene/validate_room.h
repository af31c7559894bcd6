#pragma once

#include "engine/scene/scene.h"

namespace gurney {

/// @throws Error naming every value of the room and of the pairs of materials outside its range, a
///         line each.
void validate_room(const Scene& scene);

}  // namespace gurney
