#pragma once

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

namespace gurney {

/// Runs one scene on one floor motion. The only entry point of the engine; keeps no state between
/// calls and may be called from several threads at once.
///
/// @throws Error for a scene or settings outside their ranges. Physics or numerics gone
///         wrong is not an error but an Outcome.
Response simulate(const Scene& scene, const FloorMotion& floor, const SimulationSettings& settings);

}  // namespace gurney
