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

/// The run again with masses changed by kPerturbation, and with half its time step and no history.
/// @throws Error as simulate()
Response twin_run(const Scene& scene, const FloorMotion& floor, const SimulationSettings& settings);
Response half_step_run(const Scene& scene, const FloorMotion& floor,
                       const SimulationSettings& settings);

/// Takes the demands of each item at half step, and what they say of items that may meet; nothing of a run
/// that failed.
void add_half_step(const Scene& scene, const Response& run, const Response& half,
                   std::vector<Predictability>& of_items);

}  // namespace gurney
