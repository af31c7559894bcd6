#pragma once

#include "engine/base/floor_motion.h"
#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

namespace gurney {

/// Runs with settings.peak_error > 0: halves the time step until two halvings one after the other
/// change the peaks of every item by at most half of that error, Quality::kLargestHalvings times at
/// most, and returns the last run. Items whose motion is chaotic at the first step do not count: no
/// step gives them a number. A run that fails is tried with shorter steps too.
/// Quality::step_halvings and peak_change say what came of it.
/// @throws Error as simulate()
Response refine(const Scene& scene, const FloorMotion& floor, const SimulationSettings& settings);

/// The settings of a run that refine() returned, whose peak_error is 0; else `settings`.
SimulationSettings refined_settings(const SimulationSettings& settings, const Quality& quality);

/// The largest relative change of the peaks of displacement and tilt between two runs of an item; of
/// one that overturns in both, of the time of that; infinite where it overturns in one. Peaks that
/// count as rest (Predictability) do not change.
double peak_change(const Demands& run, const Demands& finer);

}  // namespace gurney
