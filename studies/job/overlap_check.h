#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.h"
#include "equipment/catalogue/sampler.h"

namespace gurney::study {

/// Notes each item that stands in another one or in the room.
/// @param positions  where they are stated, as Scene::items
void check_overlaps(const std::vector<config::Spot>& positions, const Scene& scene,
                    equipment::Sampler& of);

/// A warning for each item that stands in a zone at the start: the zone then counts as entered in
/// every run.
std::vector<std::string> warnings_of_zones(const Scene& scene);

}  // namespace gurney::study
