#pragma once

#include "engine/config/table.h"
#include "equipment/catalogue/room_description.h"
#include "studies/job/job_parts.h"

namespace gurney::study {

/// The tables [item] or [[item]] of a job. Each of [[item]] is drawn as a part with its name.
/// Errors are noted in the document.
/// @param names  takes the name of each
/// @return as Scene::items; empty where there is an error in them
std::vector<config::Table> read_items(config::Table& root, equipment::UniqueNames& names,
                                      JobReading& job);

/// Adds the parts and contents of each item to the scene, after the items, named `item/part`.
void unfold_items(JobReading& job);
/// Places them as their items stand when all that is read.
void place_unfolded(JobReading& job);

/// Loads, fixture and start of the only item of a job, where they stand at the top of the job:
/// [[excitation.force]] and the other loads, [fixture], [initial]. In a job of several items each
/// is an error.
void read_acting_at_top(config::Table& root, JobReading& job);

}  // namespace gurney::study
