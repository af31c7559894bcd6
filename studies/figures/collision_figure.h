#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.h"
#include "studies/analysis/stored_histories.h"
#include "studies/figures/chart.h"

namespace gurney::figures {

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

}  // namespace gurney::figures
