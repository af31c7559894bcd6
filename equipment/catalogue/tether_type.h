#pragma once

#include <limits>
#include <string>
#include <vector>

#include "equipment/catalogue/uncertainty.h"

namespace gurney::equipment {

/// A kind of cord, hose or line as its file describes it (docs/formats/room_file.md).
struct TetherType {
  std::string name;
  double axial_stiffness = 0;  ///< force per strain; over the length the stiffness, > 0 [N]
  double damping = 0;          ///< while taut, >= 0 [N s/m]
  double strength = std::numeric_limits<double>::infinity();  ///< > 0 [N]
  double slack_pull = 0;  ///< horizontally towards the anchor, taut or not, >= 0 [N]
  std::vector<Assumption> assumptions;
};

/// @throws Error with every error of the file.
Uncertain<TetherType> load_tether_type(const std::string& file);

}  // namespace gurney::equipment
