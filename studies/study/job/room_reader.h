#pragma once

#include "engine/config/table.h"
#include "equipment/catalogue/room_description.h"
#include "studies/study/job/items_reader.h"
#include "studies/study/job/job.h"

namespace gurney::study {

/// The table [room] of a job: a room file, and what the job itself puts there. Mistakes are noted
/// in the document.
equipment::RoomDescription read_job_room(config::Table& root, equipment::RoomNames& names);

/// Puts the room into the job's scene, gives the materials that nobody stated, and the constants of
/// each pair that may touch, with what they rest on. A pair without constants is noted.
/// @param items  as Scene::items
void furnish(config::Table& root, std::vector<JobItem>& items, equipment::RoomDescription room,
             Job& job);

}  // namespace gurney::study
