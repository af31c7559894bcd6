#pragma once

#include <string>

#include "engine/config/table.h"
#include "groundmotions/buildings/building.h"

namespace gurney::groundmotions {

/// Reads the keys of a building; docs/formats/building_file.md. Errors are noted in the table's
/// document, and the building is then a rigid one.
/// @param name  if the table has none
Building read_building(config::Table& table, const std::string& name = "building");

/// The key `floor`: a number from 0 to building.storeys, or "roof".
int read_floor(config::Table& table, const Building& building);

/// A file of its own: `schema = "gurney-building/1"`, `name`, and the keys of a building.
/// @throws Error with every error of the file.
Building building_from_file(const std::string& path);

}  // namespace gurney::groundmotions
