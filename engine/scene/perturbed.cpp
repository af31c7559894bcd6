#include "engine/scene/perturbed.h"

namespace gurney {

Scene perturbed(Scene scene, std::size_t number) {
  const double factor = 1 + static_cast<double>(number) * kPerturbation;
  for (PlacedItem& item : scene.items) {
    item.model.chassis_mass *= factor;
    item.model.chassis_inertia *= factor;
  }
  return scene;
}

}  // namespace gurney
