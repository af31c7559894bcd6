#pragma once

#include <string>

#include "engine/response/response.h"
#include "studies/results/run_facts.h"
#include "studies/units/unit_system.h"

namespace gurney::figures {

/// One page of SVG: the scene from above; for a single item histories of
/// the floor acceleration, displacement, velocity, acceleration, yaw and tilt, swivel angles,
/// normal forces and energy, and when it is pulled its pull as well; for several items the distance
/// from the start and the tilt of each, in the colours of the plan. Without a history it says so.
std::string run_figure(const study::RunFacts& facts, const Response& response,
                       const study::UnitSystem& units = {});

}  // namespace gurney::figures
