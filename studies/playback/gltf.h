#pragma once

#include <string>
#include <vector>

#include "studies/playback/recorded_run.h"

namespace gurney::playback {

/// Corners of triangles, three for each, anticlockwise as seen from outside.
std::vector<Vector3> triangles(const RecordedShape& shape);

/// A wheel about the y axis of its own axes.
RecordedShape shape_of(const RecordedWheel& wheel);

/// A run as an animated scene of glTF 2.0 (Khronos Group, 2021), in one file with its buffer inside:
/// the room, a node for each item, in it one for each fork and wheel. Metres, seconds, y upwards;
/// single precision.
std::string gltf(const RecordedRun& run);

}  // namespace gurney::playback
