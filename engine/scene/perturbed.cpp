#include "engine/scene/perturbed.h"

#include <utility>

#include "engine/base/random/draw.h"

namespace gurney {
namespace {

Scene heavier(Scene scene, double factor) {
  for (PlacedItem& item : scene.items) {
    item.model.chassis_mass *= factor;
    item.model.chassis_inertia *= factor;
  }
  return scene;
}

}  // namespace

Scene perturbed(Scene scene, std::size_t number) {
  return heavier(std::move(scene), 1 + static_cast<double>(number) * kPerturbation);
}

Scene replica_of(Scene scene, std::size_t replica) {
  if (replica == 0) return scene;
  const double share = 2 * Draw(0, replica).probability("replica") - 1;
  return heavier(std::move(scene), 1 + kReplicaSpread * share);
}

}  // namespace gurney
