#pragma once

#include <vector>

#include "engine/base/vector.h"

namespace gurney {

using Polygon = std::vector<Vector2>;  ///< convex, anticlockwise

/// The smallest convex polygon around points: Andrew's monotone chain (1979, Information Processing
/// Letters 9(5), 216-219). Fewer than three points are returned as they are.
Polygon convex_polygon(std::vector<Vector2> points);

}  // namespace gurney
