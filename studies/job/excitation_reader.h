#pragma once

#include "engine/config/table.h"
#include "studies/job/job_parts.h"

namespace gurney::study {

/// Each reader notes errors in its table's document.

/// The forces, drop weights, string potentiometers and blocks of a table [item] or [excitation],
/// after those that the item has.
void read_loads(config::Table& table, equipment::Uncertain<PlacedItem>& item);

/// The tables `fixture` and `initial` of an item or a job.
void read_fixture(config::Table& fixture, equipment::Uncertain<PlacedItem>& item);
void read_initial(config::Table& initial, equipment::Uncertain<PlacedItem>& item);

}  // namespace gurney::study
