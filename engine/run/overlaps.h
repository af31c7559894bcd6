#pragma once

#include <cstddef>
#include <vector>

#include "engine/scene/scene.h"

namespace gurney {

/// An item that stands in something at the start.
struct Overlap {
  std::size_t item = 0;
  int other_item = -1;  ///< index > item; -1: a room shape
  int shape = -1;       ///< index of the room shape
  double depth = 0;     ///< > 0 [m]
};

/// Chassis and wheels as placed against the room and each other; deeper than 1 mm counts.
/// @throws Error for a scene outside its ranges.
std::vector<Overlap> find_overlaps(const Scene& scene);

/// An item that stands in a zone at the start.
struct OccupiedZone {
  std::size_t zone = 0, item = 0;
};

/// By zone, then by item. @throws Error for a scene outside its ranges.
std::vector<OccupiedZone> find_occupied_zones(const Scene& scene);

}  // namespace gurney
