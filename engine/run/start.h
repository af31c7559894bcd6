#pragma once

#include "engine/solver/assembly.h"

namespace gurney {

/// Everything placed, settled and set in motion.
/// @throws Error where an item does not come to rest
SceneState start_of(const Scene& scene, const Assembly& assembly);

}  // namespace gurney
