#pragma once

#include <vector>

#include "engine/response/predictability.h"
#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

namespace gurney {

/// Compares a run with its twin, both with histories at the same times.
/// @returns one for each item
std::vector<Predictability> compare_twin(const Response& run, const Response& twin);

/// Runs the twin of a run that did not fail.
/// @param run  the response of simulate(scene, floor, settings); repeated where it has no history
/// @returns one for each item; none where the twin fails
/// @throws Error as simulate()
std::vector<Predictability> predictability(const Scene& scene, const FloorMotion& floor,
                                           SimulationSettings settings, const Response& run);

/// Runs the run again with half its time step, for the demands of each item at half step.
/// @throws Error as simulate()
void add_half_step(const Scene& scene, const FloorMotion& floor, const SimulationSettings& settings,
                   std::vector<Predictability>& of_items);

}  // namespace gurney
