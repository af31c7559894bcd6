#pragma once

#include <vector>

#include "engine/response.h"
#include "engine/scene/scene.h"
#include "studies/report/panel.h"

namespace gurney {

/// Draws the path of the item's origin from above, with the outline of its boxes and its casters at
/// the start (grey) and at the end (coloured). `history` must not be empty.
void draw_plan(Svg& svg, const Frame& frame, const Scene& scene,
               const std::vector<Sample>& history);

}  // namespace gurney
