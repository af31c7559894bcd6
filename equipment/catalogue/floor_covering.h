#pragma once

#include <string>
#include <vector>

#include "engine/config/table.h"
#include "equipment/catalogue/uncertainty.h"

namespace gurney::equipment {

/// Effect of a floor covering on the constants of a caster, which are those on smooth vinyl.
struct FloorCovering {
  std::string name;
  double rolling_resistance_factor = 1;  ///< on Cr and b, >= 0
  double friction_factor = 1;            ///< on mu_s and mu_k, >= 0
  std::vector<Assumption> assumptions;
};

/// Notes errors in the table's document; the result is for use only after its `finish`.
Uncertain<FloorCovering> read_floor(config::Table table);

/// @throws Error with every error of the file.
Uncertain<FloorCovering> load_floor_covering(const std::string& file);

/// How far a floor is out of level: rise over run along x and y.
struct Levelness {
  double slope = 0, cross_slope = 0;
  std::vector<Assumption> assumptions;
};

/// Levelness of equipment/levelness.toml.
/// @throws Error with every error of the file.
Uncertain<Levelness> usual_levelness();

}  // namespace gurney::equipment
