#pragma once

#include <string>

#include "studies/playback/recorded_run.h"

namespace gurney::playback {

/// A run as an animated scene of glTF 2.0 (Khronos Group, 2021), in one file with its buffer inside:
/// the room, a node for each item, in it one for each fork and wheel. Metres, seconds, y upwards;
/// single precision.
std::string gltf(const RecordedRun& run);

}  // namespace gurney::playback
