#pragma once

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

namespace gurney {

/// One integration by our solver, with the steps that the settings state: what run() (run.h) makes
/// once or, for RunOptions::peak_error, several times. Where a single item overturned, the energy
/// balance being right, and its run failed afterwards, the run ends at the overturning and
/// Response::cause says so.
///
/// @throws Error for a scene or settings outside their ranges. Physics or numerics gone
///         wrong is not an error but an Outcome.
Response simulate(const Scene& scene, const FloorMotion& floor, const SimulationSettings& settings);

}  // namespace gurney
