#pragma once

#include <vector>

#include "engine/base/config/table.h"
#include "engine/scene/scene.h"

namespace gurney {

/// Notes each item that stands in another one or in the room.
/// @param items  their tables, as Scene::items
void check_overlaps(std::vector<config::Table>& items, const Scene& scene);

}  // namespace gurney
