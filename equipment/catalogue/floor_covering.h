#pragma once

#include <string>
#include <vector>

#include "engine/config/table.h"
#include "equipment/catalogue/uncertain.h"

namespace gurney::equipment {

/// What a floor covering does to the constants of a caster, which are those on smooth vinyl.
struct FloorCovering {
  std::string name;
  double rolling_resistance_factor = 1;  ///< on Cr, >= 0
  double friction_factor = 1;            ///< on mu_s and mu_k, >= 0
  std::vector<Assumption> assumptions;
};

/// Notes errors in the table's document; the result is for use only after its `finish`.
Uncertain<FloorCovering> read_floor(config::Table table);

/// @throws Error with every error of the file.
Uncertain<FloorCovering> load_floor_covering(const std::string& file);

}  // namespace gurney::equipment
