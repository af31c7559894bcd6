#pragma once

#include <vector>

#include "studies/playback/recorded_run.h"

namespace gurney::playback {

/// Corners of triangles, three for each, anticlockwise as seen from outside.
std::vector<Vector3> triangles(const RecordedShape& shape);

/// A wheel about the y axis of its own axes.
RecordedShape shape_of(const RecordedWheel& wheel);

}  // namespace gurney::playback
