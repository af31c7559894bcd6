#include "studies/study/job/overlap_check.h"

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

}  // namespace gurney::study
