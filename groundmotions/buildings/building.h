#pragma once

#include <array>
#include <optional>
#include <string>

#include "groundmotions/buildings/isolation.h"
#include "groundmotions/buildings/modal_building.h"
#include "groundmotions/buildings/yielding_motion.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// What stands between the ground and the equipment. The axes of the building are those of the
/// record that shakes it: h1, h2, vertical. No torsion, no soil-structure interaction.
struct Building {
  std::string name;
  int storeys = 0;                     ///< floors are 0 (the base) to `storeys` (the roof)
  std::array<ModalAxis, 3> axes;       ///< indexed by Direction; without modes: rigid
  std::optional<Isolation> isolation;  ///< below floor 0; empty: floor 0 is the ground
  std::optional<double> height;        ///< of the roof above the base, where stated [m]
  /// Storeys that yield instead of the horizontal modes, which are then those of the elastic building;
  /// without isolation and floor rotation, of stated height.
  std::optional<YieldingStoreys> yielding = {};

  const ModalAxis& operator[](Direction direction) const {
    return axes[static_cast<std::size_t>(direction)];
  }
};

/// Whether a floor turns as the building deforms.
bool rotates(const Building& building, int floor);

}  // namespace gurney::groundmotions
