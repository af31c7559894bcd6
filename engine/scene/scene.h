#pragma once

#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/scene/contact_pair.h"
#include "engine/scene/equipment_model.h"
#include "engine/scene/loads.h"
#include "engine/scene/room.h"

namespace gurney {

/// A flat floor, the room and what stands in it.
struct Scene {
  EquipmentModel item;
  InitialMotion initial;
  double gravity = 9.80665;  ///< >= 0 [m/s2]
  double slope = 0;          ///< of the floor: rise over run, the x axis points uphill
  std::string floor_material;
  std::vector<RoomShape> room;
  std::vector<MaterialPair> pairs;  ///< of item.material with floor_material and those of the room
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

/// Constants of the item's chassis against `other`: those of the pair, or the defaults where both
/// materials are empty.
/// @throws Error when named materials have no pair.
ContactConstants contact_constants(const Scene& scene, const std::string& other);

/// @throws Error naming every value outside its range, the item's included.
void validate(const Scene& scene);
void validate(const Excitation& excitation);

}  // namespace gurney
