#include "studies/job/overlap_check.h"

#include <fmt/format.h>

#include "engine/base/units.h"
#include "engine/run/overlaps.h"

namespace gurney::study {

void check_overlaps(const std::vector<config::Spot>& positions, const Scene& scene,
                    equipment::Sampler& of) {
  if (scene.items.size() == 1 && scene.room.empty()) return;
  for (const Overlap& overlap : find_overlaps(scene)) {
    const bool item = overlap.other_item >= 0;
    // The later of two items: the first stands where it was put.
    const std::size_t later = item ? static_cast<std::size_t>(overlap.other_item) : overlap.item;
    const std::string& other = item ? scene.items[overlap.item].name
                                    : scene.room[static_cast<std::size_t>(overlap.shape)].name;
    of.error(positions[later],
             fmt::format(": '{}' stands {:.0f} mm deep in '{}'", scene.items[later].name,
                         overlap.depth * kMillimetersPerMeter, other));
  }
}

std::vector<std::string> warnings_of_zones(const Scene& scene) {
  std::vector<std::string> warnings;
  for (const OccupiedZone& each : find_occupied_zones(scene)) {
    const PlacedItem& item = scene.items[each.item];
    warnings.push_back(fmt::format(
        "zone '{}': '{}' stands in it at the start, so that every run counts as an entry",
        scene.zones[each.zone].name, item.name.empty() ? item.model.name : item.name));
  }
  return warnings;
}

}  // namespace gurney::study
