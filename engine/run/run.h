#pragma once

#include "engine/base/floor_motion.h"
#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

namespace gurney {

/// The engine: runs a scene under a floor motion and returns what it did.
///
///     Scene scene = scene_of(model);                    // engine/scene: items, room, loads
///     const FloorMotion floor(0.005, accelerations);    // 3 rows: x, y, z [m/s2]
///     const Response response = run(scene, floor, {});  // engine/response: demands, histories
///
/// Settings take any solver and any way to choose the time step: fixed steps (`time_step`), steps as
/// short as a `tolerance` needs, or fixed steps halved until the peaks are as accurate as
/// `peak_error` says; ours or, for comparison, a baseline on stock Bullet (`solver`). An ensemble of
/// slightly different runs is made by run() of perturbed() scenes (engine/scene/perturbed.h).
///
/// Keeps no state between calls and may be called from several threads at once; the response has
/// the same bits whatever runs beside it.
///
/// @param floor  none: a floor at rest
/// @throws Error for a scene or settings outside their ranges, and for what a baseline does not know.
///         Physics or numerics gone wrong is no error but an Outcome (Response::outcome).
Response run(const Scene& scene, const FloorMotion& floor, const SimulationSettings& settings);

/// Adds to the response of such a run what a twin with slightly other masses and a run with half its
/// time step show of each item (ItemResponse::predictability); nothing where a baseline made it or
/// where it failed. It costs two runs.
void add_predictability(const Scene& scene, const FloorMotion& floor,
                        const SimulationSettings& settings, Response& response);

}  // namespace gurney
