#pragma once

#include <string>

#include "engine/scene/scene.h"
#include "studies/figures/plot_page.h"

namespace gurney::figures {

/// A scene before anything moves, from above: the room, its zones and tethers, the boxes of the
/// items with their fronts, the wheels.
std::string scene_figure(const PlotPage& page, const std::string& title, const Scene& scene);

}  // namespace gurney::figures
