#pragma once

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

namespace gurney::baselines {

/// Runs one scene with the solver that its settings name: simulate(), or a baseline on stock
/// Bullet.
/// @throws Error as these do
Response simulate_with_any_solver(const Scene& scene, const FloorMotion& floor,
                                  const SimulationSettings& settings);

/// Adds to a response what its twin and half its time step show of each item
/// (engine/run/predictability.h); nothing where a baseline made it or where it failed.
void add_predictability(const Scene& scene, const FloorMotion& floor,
                        const SimulationSettings& settings, Response& response);

}  // namespace gurney::baselines
