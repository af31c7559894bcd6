#pragma once

#include <optional>
#include <vector>

#include "engine/config/table.h"
#include "equipment/catalogue/floor_covering.h"
#include "equipment/catalogue/unique_names.h"
#include "studies/study/job/job.h"

namespace gurney::study {

/// What a job says of an item besides the scene's part.
struct JobItem {
  config::Table table;
  /// The item's own: against anything, and last against the floor; empty: none.
  std::vector<ContactConstants> contacts;
};

/// The tables [item] or [[item]] of a job, into its scene, assumptions and warnings. Each of
/// [[item]] is drawn as a part with its name. Mistakes are noted in the document.
/// @param names  takes the name of each
/// @return as Scene::items; empty where there is a mistake in them
std::vector<JobItem> read_items(config::Table& root,
                                const std::optional<equipment::FloorCovering>& covering,
                                equipment::UniqueNames& names, Job& job);

/// What acts on the only item of a job, where it stands at the top of the job: [[excitation.force]]
/// and the other loads, [fixture], [initial]. In a job of several items each is an error.
void read_acting_at_top(config::Table& root, Job& job);

}  // namespace gurney::study
