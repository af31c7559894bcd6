#pragma once

#include <vector>

#include "engine/scene/equipment_model.h"

namespace gurney::equipment {

/// Where a wheel stands in plan: somewhere on a circle round `center`; or a corner of a foot.
struct Support {
  Vector2 center;  ///< item axes [m]
  double radius;   ///< >= 0 [m]
};

enum class Swivels {
  kAsPlaced,  ///< forks at their initial headings: all radii are 0
  kAnywhere   ///< free forks stand as is worst; locked and rigid ones as placed
};

/// Of an item without casters: the corners of those boxes whose lowest face is on the floor, within
/// 1e-6 m of the lowest of all.
std::vector<Support> supports_of(const EquipmentModel& item, Swivels swivels);

/// How far a point lies inside an edge of the supports.
struct Margin {
  double distance;   ///< negative: outside [m]
  double direction;  ///< of the edge's outward normal, from the x axis, anticlockwise [rad]
};

/// The edge nearest to `point`: the smallest over all directions n of
/// max_i(center_i . n - radius_i) - point . n. Exact: between directions in which two supports
/// tie, every branch is a sinusoid.
Margin smallest_margin(const std::vector<Support>& supports, const Vector2& point);

/// How far `point` can go towards `direction` before it leaves the supports: the smallest over the
/// edges m of margin(m) / (m . direction). Exact for the same reason. Infinite without such an
/// edge.
/// @param direction  from the x axis, anticlockwise [rad]
double reach_towards(const std::vector<Support>& supports, const Vector2& point, double direction);

/// The corners of the smallest convex polygon around the centres, anticlockwise.
std::vector<Vector2> hull_of(const std::vector<Support>& supports);

}  // namespace gurney::equipment
