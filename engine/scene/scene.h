#pragma once

#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/scene/equipment_model.h"
#include "engine/scene/loads.h"

namespace gurney {

/// A flat floor and what stands on it.
struct Scene {
  EquipmentModel item;
  InitialMotion initial;
  double gravity = 9.80665;  ///< >= 0 [m/s2]
  double slope = 0;          ///< of the floor: rise over run, the x axis points uphill
};

/// What acts on the scene.
struct Excitation {
  FloorMotion floor;
  std::vector<PointForce> forces;
  std::vector<StringPotentiometer> string_potentiometers;
  std::vector<DropWeight> drop_weights;
  std::vector<Blocks> blocks;
  Fixture fixture;
};

/// @throws Error naming every value outside its range, the item's included.
void validate(const Scene& scene);
void validate(const Excitation& excitation);

}  // namespace gurney
