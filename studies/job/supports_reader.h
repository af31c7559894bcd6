#pragma once

#include <vector>

#include "engine/config/table.h"
#include "studies/job/job_parts.h"

namespace gurney::study {

/// The key `on` of items: what each stands on in place of the floor, an item before it or a box or column of the
/// room. Its position and yaw are then those in the axes of that item. The room is in the scene already.
/// @param items  as Scene::items
void read_supports(const std::vector<config::Table>& items, JobReading& job);

}  // namespace gurney::study
