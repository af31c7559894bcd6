#include "engine/run/overlaps.h"

#include <algorithm>

#include "engine/bullet/contact_search.h"
#include "engine/record/zone_log.h"
#include "engine/solver/assembly.h"
#include "engine/solver/equilibrium.h"

namespace gurney {
namespace {

constexpr double kLeastDepth = 1e-3;  // [m]

}  // namespace

std::vector<Overlap> find_overlaps(const Scene& scene) {
  validate(scene);
  const Assembly assembly(scene);
  SceneState state;
  for (std::size_t i = 0; i < scene.items.size(); ++i)
    state.items.push_back(placed_above(assembly, scene, i));
  std::vector<Overlap> overlaps;
  const auto note = [&](const BodyContact& contact, double depth) {
    const Overlap here{contact.side.item,
                       contact.between_items() ? static_cast<int>(contact.other_side.item) : -1,
                       contact.between_items() ? -1 : contact.other - 1, depth};
    for (Overlap& known : overlaps)
      if (known.item == here.item && known.other_item == here.other_item &&
          known.shape == here.shape) {
        known.depth = std::max(known.depth, depth);
        return;
      }
    overlaps.push_back(here);
  };
  ContactSearch search(scene, assembly, false);
  for (const BodyContact& contact : search.find(state, 0)) {
    const double depth = -assembly.gap(contact, state);
    if (contact.other != 0 && depth > kLeastDepth) note(contact, depth);
  }
  return overlaps;
}

std::vector<OccupiedZone> find_occupied_zones(const Scene& scene) {
  std::vector<OccupiedZone> found;
  if (scene.zones.empty()) return found;
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    Scene alone = scene;
    alone.items = {scene.items[i]};
    alone.items[0].on.reset();
    alone.joints.clear();
    alone.tethers.clear();
    validate(alone);
    const Assembly assembly(alone);
    SceneState state;
    state.items.push_back(assembly.items[0].placed(alone.items[0].initial));
    ZoneLog log(alone, assembly);
    log.observe(0, 0, state);
    for (std::size_t z = 0; z < scene.zones.size(); ++z)
      if (log.outcomes()[z].occupied_at_end) found.push_back({z, i});
  }
  std::ranges::stable_sort(found, {}, &OccupiedZone::zone);
  return found;
}

}  // namespace gurney
