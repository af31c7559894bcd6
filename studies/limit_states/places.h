#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/scene/scene.h"
#include "studies/limit_states/limit_state.h"

namespace gurney::study {

/// What limit states may name: the items of a run, their marked points, its zones and tethers.
struct Places {
  std::vector<std::string> items, zones, tethers;
  std::vector<std::pair<std::string, std::string>> points;  ///< item and point
};

Places places_of(const Scene& scene);

/// Complains of items, points, zones and tethers that are not there.
/// @param owner  of the places, for messages: "the job"
/// @throws Error with the nearest name
void check_names(const LimitState& state, const Places& places, const std::string& owner);

}  // namespace gurney::study
