#pragma once

#include <vector>

#include "equipment/catalogue/uncertain.h"

namespace gurney::equipment {

/// How far a floor is out of level: rise over run along x and y.
struct Levelness {
  double slope = 0, cross_slope = 0;
  std::vector<Assumption> assumptions;
};

/// That of equipment/levelness.toml.
/// @throws Error with every error of the file.
Uncertain<Levelness> usual_levelness();

}  // namespace gurney::equipment
