#pragma once

#include "engine/scene/scene.h"
#include "equipment/catalogue/load_item.h"

namespace gurney {

/// The item alone on a level floor.
inline Scene standing(const equipment::LoadedItem& item) {
  Scene scene = scene_of(item.model);
  scene.pairs = item.pairs;
  scene.floor_material = item.floor_material;
  return scene;
}

}  // namespace gurney
