#pragma once

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "studies/results/hdf5_writer.h"

namespace gurney::study {

/// The groups that hold one row for each item, wheel, point, impact, zone or tether of a run:
/// /items, /energy, /wheels, /points, /events, /zones and /tethers. All columns are 1-D.
void add_tables(Hdf5Writer& file, const Scene& scene, const Response& response);

}  // namespace gurney::study
