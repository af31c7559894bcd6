#pragma once

#include <string>

#include "engine/scene/scene.h"
#include "studies/figures/chart.h"

namespace gurney::figures {

/// Room, zones, tethers and items of a scene before anything moves, on the axes of a plan [m].
Panel scene_panel(const Scene& scene);

/// A plan in metres in another unit, which its labels state.
void set_unit(Panel& plan, const study::UnitSystem& units);

/// Height over width of the curves and marks of a plan, within what a page has room for.
double aspect_of_plan(const Panel& panel);

/// A scene before anything moves, from above: the room, its zones and tethers, the boxes of the
/// items with their fronts, the wheels.
std::string scene_figure(const PlotPage& page, const std::string& title, const Scene& scene);

}  // namespace gurney::figures
