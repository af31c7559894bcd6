#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/config/table.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// Accelerations of floors that another program computed, in tables: some files for each ground motion.
struct FloorTables {
  /// Column of numbers, or time series of a JSON file. Without floor and direction it is skipped.
  struct Column {
    bool is_time = false;
    std::optional<std::size_t> floor = {};  ///< index in `floors`
    std::optional<Direction> direction = {};
  };

  std::vector<std::string> floors;        ///< at least one, lowest first
  std::array<std::string, 3> directions;  ///< names of h1, h2, vertical in paths and columns
  /// Path of the files of one ground motion: `{record}` stands for its name, `{floor}` and
  /// `{direction}` for the names above.
  std::string pattern;
  std::vector<std::string> columns;  ///< as stated; empty: the files are JSON
  std::string series;                ///< name of a time series in JSON, with placeholders likewise
  std::string unit;                  ///< as acceleration_unit() takes it
  std::optional<double> time_step;   ///< where no column has the time; the first row is at 0 s [s]
  bool relative = false;      ///< accelerations are relative to the base, which moves as the ground
  bool proportional = false;  ///< of an elastic structure: floors move in proportion to the ground
  double ground_scale = 1;    ///< factor on the ground motion with which they were computed
  std::string where;          ///< place of the pattern, for messages
};

/// Reads the keys of `kind = "tables"`; errors are noted in the table's document.
FloorTables read_floor_tables(config::Table& table);

/// The absolute acceleration of one floor under a ground motion whose name is that of its tables. A
/// direction that the tables lack moves as the ground.
/// @param floor  index in tables.floors
/// @throws Error for files that are missing, that are no such tables or do not fit together, and for a
///         ground motion scaled otherwise than that of the tables, unless they are proportional
Record floor_from_tables(const Record& ground, const FloorTables& tables, std::size_t floor);

}  // namespace gurney::groundmotions
