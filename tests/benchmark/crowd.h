#pragma once

#include "engine/scene/scene.h"

namespace gurney::benchmark {

/// Trolleys in rows, 0.15 m from each other and from the walls around them, each with other headings.
Scene crowd(int columns, int rows);

}  // namespace gurney::benchmark
