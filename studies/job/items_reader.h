#pragma once

#include <optional>
#include <vector>

#include "engine/base/config/table.h"
#include "equipment/floor_covering.h"
#include "equipment/unique_names.h"
#include "studies/job/job.h"

namespace gurney {

/// The tables [item] or [[item]] of a job, into its scene, assumptions and warnings. Each of
/// [[item]] is drawn as a part with its name. Mistakes are noted in the document.
/// @param names  takes the name of each
/// @return the tables, as Scene::items; empty where there is a mistake in them
std::vector<config::Table> read_items(config::Table& root,
                                      const std::optional<FloorCovering>& covering,
                                      UniqueNames& names, Job& job);

}  // namespace gurney
