#pragma once

#include "groundmotions/buildings/floor_record.h"

namespace gurney::groundmotions {

/// Peak rotation of the floor; a warning where it is not small.
void report_rotation(Record& floor);

/// How much the building's own frequency amplifies the vertical; a warning above 1 g.
void report_vertical(const Record& ground, const Building& building, BuildingResponse& response);

/// The storey drift ratio, where the building's height is stated; a warning above 1 %.
/// @param largest  difference of the displacements of two floors [m]
void report_storey_drift(double largest, const Building& building, BuildingResponse& response);

/// A ground that moves on when its record ends carries the floor on while the building vibrates:
/// a warning where that is visible.
/// @param tail  time for which it vibrates [s]
void report_drift(const Record& ground, double tail, Record& floor);

}  // namespace gurney::groundmotions
