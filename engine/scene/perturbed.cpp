#include "engine/scene/perturbed.h"

namespace gurney {

Scene perturbed(const Scene& scene, std::size_t number) {
  Scene result = scene;
  if (number == 0) return result;
  const double factor = 1 + static_cast<double>(number) * kPerturbation;
  for (PlacedItem& item : result.items) {
    item.model.chassis_mass *= factor;
    item.model.chassis_inertia *= factor;
  }
  return result;
}

}  // namespace gurney
