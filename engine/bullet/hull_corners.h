#pragma once

#include <vector>

#include "engine/base/vector.h"

namespace gurney {

/// Points, sorted, among which are all corners of the convex hull of the given ones, by Bullet's
/// btConvexHullComputer, which resolves 1e-4 of their size. Empty: they span no volume that it sees.
std::vector<Vector3> hull_corners(std::vector<Vector3> points);

}  // namespace gurney
