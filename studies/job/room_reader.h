#pragma once

#include <optional>
#include <vector>

#include "engine/config/table.h"
#include "studies/job/job_parts.h"

namespace gurney::study {

/// The table [room] of a job: a room file, and what the job itself puts there. Errors are noted
/// in the document.
void read_job_room(config::Table& root, equipment::RoomNames& names, JobReading& job);

/// Puts the room into the job's scene, gives the materials that nobody stated, and the constants of
/// each pair that may touch, with what they rest on. A pair without constants is noted.
/// @param items  as Scene::items; none: there is an error in them
void furnish(config::Table& root, std::vector<config::Table>& items, JobReading& job);

/// Where the slack length of each tether stands, as Scene::tethers; none of one that has errors.
using TetherSpots = std::vector<std::optional<config::Spot>>;

/// The tables [[tether]] of a job; the items with their parts and the room must be read, where a tether may
/// end. Errors are noted in the document.
TetherSpots read_tethers(config::Table& root, JobReading& job);

/// Notes each tether that is too short where all is placed.
void check_tethers(const TetherSpots& spots, config::Document& document, JobReading& job);

/// The key `on` of items: what each stands on in place of the floor, an item before it or a box or column of the
/// room. Its position and yaw are then those in the axes of that item. The room is in the scene already.
/// @param items  as Scene::items
void read_supports(const std::vector<config::Table>& items, JobReading& job);

}  // namespace gurney::study
