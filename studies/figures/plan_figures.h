#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.h"
#include "studies/analysis/stored_histories.h"
#include "studies/figures/chart.h"

namespace gurney::figures {

/// Room, zones, tethers and items of a scene before anything moves, on the axes of a plan [m].
Panel scene_panel(const Scene& scene);

/// A plan in metres in another unit, which its labels state.
void set_unit(Panel& plan, const study::UnitSystem& units);

/// Height over width of the curves and marks of a plan, within what a page has room for and `most`.
double aspect_of_plan(const Panel& panel, double most = 0.8);

/// A scene before anything moves, from above: the room, its zones and tethers, the boxes of the
/// items with their fronts, the wheels.
std::string scene_figure(const PlotPage& page, const std::string& title, const Scene& scene);

/// Where the items of a scene hit something.
struct CollisionMap {
  std::string name;  ///< of the configuration
  Scene scene;
  std::vector<study::StoredImpact> impacts;
  std::size_t runs = 0;
};

/// The plans with a circle at each impact, larger for a larger approach speed.
std::string collision_figure(const PlotPage& page, const std::string& title,
                             const std::string& note, const std::vector<CollisionMap>& maps);

/// The paths of the items seen from above. Of the file of one run with the room, the outlines of
/// the items at the start and at the end, their fronts, and the points of impact; of a study the
/// paths of all runs with histories, from the start of each.
std::string trajectory_figure(const PlotPage& page, const std::string& path);

}  // namespace gurney::figures
