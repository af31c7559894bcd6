#pragma once

#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"

namespace gurney {

/// Halves the time step until two halvings one after the other change no demand
/// (engine/response/settled.h) by more than half of `peak_error`,
/// Quality::kLargestHalvings times at most, and returns the last run. Demands that are chaotic at
/// the first step by the twin, and all of an item whose motion is, do not count: no step gives them
/// a number. Of an item that overturns only the time and the direction of that count. A run that
/// fails is tried with shorter steps too. Quality::step_halvings and peak_change say what came of it.
/// @param peak_error  (0, 0.1]
/// @throws Error as simulate(), and for a `peak_error` outside its range
Response refine(const Scene& scene, const FloorMotion& floor, const SimulationSettings& settings,
                double peak_error);

/// The settings of a run that run() returned: `settings` with its Quality::step_halvings.
SimulationSettings refined_settings(SimulationSettings settings, const Quality& quality);

/// The largest relative_change() of a demand between two runs of an item.
/// @param judged  by number of numbers_of(), whether it counts; empty: each does
double demand_change(const Demands& run, const Demands& finer,
                     const std::vector<bool>& judged = {});

}  // namespace gurney
