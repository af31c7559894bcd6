#include "engine/record/support_log.h"

#include <algorithm>

namespace gurney {
namespace {

/// What stands on an item that overturns comes down with it: below this part of the surface's height.
constexpr double kCameDown = 0.5;

}  // namespace

SupportLog::SupportLog(const Scene& scene, const Assembly& assembly, const SceneState& at_start) {
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    if (!scene.items[i].on) continue;
    Supported each{i, *scene.items[i].on, assembly.items[i].chassis.center_of_mass.z(), {}};
    each.start = place_of(each, at_start);
    supported_.push_back(each);
  }
}

Vector3 SupportLog::place_of(const Supported& each, const SceneState& state) {
  const Vector3& here = state.items[each.item].position;
  if (each.support.kind == Support::Kind::kShape) return here;
  const State& below = state.items[each.support.index];
  return below.rotation.conjugate() * (here - below.position);
}

void SupportLog::observe(double time, const SceneState& state) {
  for (Supported& each : supported_) {
    if (each.fell_at >= 0) continue;
    const Vector3 moved = place_of(each, state) - each.start;
    each.slide = std::max(each.slide, moved.head<2>().norm());
    const bool below = moved.z() < -each.height;
    const bool came_down = state.items[each.item].position.z() < kCameDown * each.support.height;
    if (below || came_down) each.fell_at = time;
  }
}

void SupportLog::finish(std::vector<ItemResponse>& items) const {
  for (const Supported& each : supported_) {
    items[each.item].demands.peak_slide = each.slide;
    items[each.item].demands.time_of_fall = each.fell_at;
  }
}

}  // namespace gurney
