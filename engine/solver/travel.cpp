#include "engine/solver/travel.h"

#include <algorithm>
#include <cmath>

namespace gurney {
namespace {

/// sin(angle / 2) of the rotation between two.
double half_sine(const Quaternion& a, const Quaternion& b) {
  return (a.w() * b.vec() - b.w() * a.vec() - a.vec().cross(b.vec())).norm();
}

}  // namespace

Travels::Travels(const Assembly& assembly, bool known)
    : assembly_(assembly), items_(assembly.items.size()) {
  if (known) return;
  for (Item& item : items_) item.travel.path = std::numeric_limits<double>::infinity();
}

void Travels::observe(const SceneState& state) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    Item& item = items_[i];
    const State& now = state.items[i];
    item.travel.path += (now.position - item.position).norm();
    item.travel.turn += 2 * half_sine(item.rotation, now.rotation);
    double swing = 0;
    const std::vector<CasterDynamics>& casters = assembly_.items[i].casters;
    for (std::size_t k = 0; k < casters.size(); ++k) {
      const double angle = now.casters[k].swivel_angle;
      swing = std::max(swing, std::abs(angle - item.swivel_angles[k]) * casters[k].swing());
      item.swivel_angles[k] = angle;
    }
    item.travel.swing += swing;
    item.position = now.position;
    item.rotation = now.rotation;
  }
}

}  // namespace gurney
