#pragma once

#include <vector>

#include "engine/scene/scene.h"
#include "studies/study/job/items_reader.h"

namespace gurney::study {

/// Notes each item that stands in another one or in the room.
/// @param items  as Scene::items
void check_overlaps(std::vector<JobItem>& items, const Scene& scene);

}  // namespace gurney::study
