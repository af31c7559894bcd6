#pragma once

#include <optional>
#include <vector>

#include "engine/config/table.h"
#include "engine/scene/loads.h"
#include "equipment/catalogue/load_item.h"
#include "studies/study/job/remarks.h"

namespace gurney::study {

/// The covering named in the table [floor] of a job, if any.
std::optional<equipment::FloorCovering> read_floor_covering(config::Table& floor);

/// A table [item] or [[item]] of a job: which item, what is changed on it, where it stands.
/// Mistakes are noted in the document; the result is empty then.
///
/// @param options  with the floor covering; the rest is read here
/// @param initial  its position and yaw are set
/// @param remarks  on options that reach no caster, or not all
std::optional<equipment::LoadedItem> read_job_item(config::Table& item,
                                                   equipment::ItemOptions& options,
                                                   InitialMotion& initial,
                                                   std::vector<equipment::Assumption>& assumptions,
                                                   Remarks& remarks);

}  // namespace gurney::study
