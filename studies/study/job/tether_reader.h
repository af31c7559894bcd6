#pragma once

#include <vector>

#include "engine/config/table.h"
#include "equipment/catalogue/room_description.h"
#include "studies/study/job/job.h"

namespace gurney::study {

/// The tables [[tether]] of a job, into its scene and assumptions; the items must be placed.
/// Mistakes are noted in the document.
/// @param points  of the room, where a tether may end
void read_tethers(config::Table& root, const std::vector<equipment::RoomPoint>& points, Job& job);

}  // namespace gurney::study
