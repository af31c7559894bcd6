#pragma once

#include <array>
#include <optional>
#include <string>

#include "engine/config/table.h"
#include "groundmotions/buildings/floor_tables.h"
#include "groundmotions/buildings/isolation.h"
#include "groundmotions/buildings/modal_building.h"
#include "groundmotions/buildings/torsion.h"
#include "groundmotions/buildings/yielding_motion.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// Structure between the ground and the equipment. The axes of the building are those of the
/// record that shakes it: h1, h2, vertical. No soil-structure interaction.
struct Building {
  std::string name;
  int storeys = 0;                     ///< floors are 0 (the base) to `storeys` (the roof)
  std::array<ModalAxis, 3> axes;       ///< indexed by Direction; without modes: rigid
  std::optional<Isolation> isolation;  ///< below floor 0; empty: floor 0 is the ground
  std::optional<double> height;        ///< of the roof above the base, where stated [m]
  /// Storeys that yield instead of the horizontal modes and those that twist, which are then of the
  /// elastic building; without isolation and floor rotation, of stated height.
  std::optional<YieldingStoreys> yielding = {};
  /// Modes of floors that twist instead of the horizontal modes, which are then those without
  /// eccentricity; without isolation and floor rotation. Empty: floors do not twist.
  std::vector<TorsionMode> torsion = {};
  /// Motions of its floors from another program instead of all of the above; floors are then those
  /// that it names, and `storeys` the number of the last.
  std::optional<FloorTables> tables = {};

  const ModalAxis& operator[](Direction direction) const {
    return axes[static_cast<std::size_t>(direction)];
  }
};

/// Whether a floor tilts as the building deforms.
bool rocks(const Building& building, int floor);

/// Number of a floor that is called so: a number, "roof", or a name of its tables; empty: there is none.
std::optional<int> floor_of(const Building& building, const std::string& name);
std::string name_of_floor(const Building& building, int floor);

/// Names of floors that floor_of() knows, for messages.
std::string floor_names(const Building& building);

/// Reads the keys of a building; docs/formats/building_file.md. Errors are noted in the table's
/// document, and the building is then a rigid one.
/// @param name  if the table has none
Building read_building(config::Table& table, const std::string& name = "building");

/// The key `floor`: a number from 0 to building.storeys, or "roof"; of tables the name of a floor.
int read_floor(config::Table& table, const Building& building);

/// A file of its own: `schema = "gurney-building/1"`, `name`, and the keys of a building.
/// @throws Error with every error of the file.
Building building_from_file(const std::string& path);

}  // namespace gurney::groundmotions
