#pragma once

#include "engine/config/table.h"
#include "groundmotions/buildings/isolation.h"

namespace gurney::groundmotions {

/// Reads the table `isolation` of a building; errors are noted in the table's document, and a
/// linear isolation that means nothing is returned.
Isolation read_isolation(config::Table& table);

}  // namespace gurney::groundmotions
