#pragma once

#include <vector>

#include "engine/base/vector.h"

namespace gurney {

/// State of the loads of one item.
struct LoadsState {
  struct Weight {
    double fall = 0, speed = 0, stretch = 0;  ///< stretch of the cable [m]
    bool landed = false;
  };
  std::vector<Weight> weights;
  std::vector<Vector2> blocks;  ///< deflections [m]
  std::vector<double> springs;  ///< of the fixture, deflections [m]

  bool empty() const { return weights.empty() && blocks.empty() && springs.empty(); }

  /// Writes y + ratio (y_first - y) of every entry, y being this, to `result`.
  void extrapolate(const LoadsState& first, double ratio, LoadsState& result) const;
};

}  // namespace gurney
