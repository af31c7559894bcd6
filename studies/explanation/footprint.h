#pragma once

#include <vector>

#include "engine/base/polygon.h"
#include "engine/response/response.h"
#include "engine/scene/scene.h"

namespace gurney::explanation {

/// The boxes of an item from above, one polygon for each, wherever it stands or lies [m].
std::vector<Polygon> footprint(const PlacedItem& item, const Sample& sample);

/// A room shape from above [m].
Polygon footprint(const RoomShape& shape);

Polygon footprint(const Zone& zone);

/// Whether two convex polygons share an area.
bool overlap(const Polygon& a, const Polygon& b);

/// The last sample that can be drawn: a run that diverged may end in numbers that are none.
/// `history` must not be empty.
const Sample& last_finite(const std::vector<Sample>& history);

}  // namespace gurney::explanation
