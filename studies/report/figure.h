#pragma once

#include <string>

#include "engine/response.h"
#include "studies/results/run_facts.h"

namespace gurney {

/// One page of SVG: the path in plan with the item and its casters at start and end, histories of
/// displacement, velocity, acceleration, normal forces, swivel angles and energy; for a pulled item
/// its pull and yaw as well. Without a history it says so.
std::string figure(const RunFacts& facts, const Response& response);

}  // namespace gurney
