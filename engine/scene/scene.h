#pragma once

#include <optional>
#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/scene/contact_pair.h"
#include "engine/scene/equipment_model.h"
#include "engine/scene/joint.h"
#include "engine/scene/loads.h"
#include "engine/scene/room.h"

namespace gurney {

/// A level surface above the floor on which an item without casters stands.
struct Support {
  enum class Kind { kItem, kShape };

  Kind kind = Kind::kItem;
  std::size_t index = 0;  ///< in Scene::items, before the item that stands on it, or Scene::room
  double height = 0;      ///< of the surface above the floor at the start, > 0 [m]
};

/// One item of the scene, how it stands there and what acts on it besides the floor.
struct PlacedItem {
  std::string name;  ///< in events: unique in a scene of several, not "floor" or of a room shape
  EquipmentModel model;
  InitialMotion initial = {};
  std::vector<Load> loads = {};
  Fixture fixture = {};
  std::optional<Support> on = {};  ///< empty: it stands on the floor
};

/// A flat floor, the room and the items that stand in it.
struct Scene {
  std::vector<PlacedItem> items;  ///< 1 or more
  double gravity = 9.80665;       ///< >= 0 [m/s2]
  double slope = 0;               ///< of the floor: rise over run along x, in [-1, 1]
  double cross_slope = 0;         ///< the same along y
  std::string floor_material;
  std::vector<RoomShape> room;
  std::vector<Zone> zones;
  std::vector<Tether> tethers;
  std::vector<Joint> joints;
  std::vector<MaterialPair> pairs;  ///< of the items' materials with all they may touch
};

/// The material of what an item stands on.
const std::string& material_below(const Scene& scene, std::size_t item);

/// A scene of one item on a bare floor.
Scene scene_of(EquipmentModel model);

/// Constants of a chassis of material `item` against `other`: those of the pair, or the defaults
/// where both are empty.
/// @throws Error when named materials have no pair.
ContactConstants contact_constants(const Scene& scene, const std::string& item,
                                   const std::string& other);

/// Index in Scene::joints of the joint of which an item is the part; none for a whole item.
std::optional<std::size_t> joint_of(const Scene& scene, std::size_t item);
/// The item on whose joints a part hangs, directly or over other parts; a whole item itself.
std::size_t root_of(const Scene& scene, std::size_t item);

/// The item that carries another over joints and supports, which stands on the floor or on a shape of the
/// room; or itself.
std::size_t carrier_of(const Scene& scene, std::size_t item);

/// Whether an item stands on another or a part of it, directly or over others.
bool stands_on(const Scene& scene, std::size_t item, std::size_t below);

/// A point of an item as it is placed, item axes, in floor axes.
Vector3 placed_point(const Scene& scene, std::size_t item, const Vector3& point);
/// Where a tether ends as all is placed, floor axes.
Vector3 placed_anchor(const Scene& scene, const Tether& tether);
/// Distance between its ends then [m].
double placed_length(const Scene& scene, const Tether& tether);

/// Places an item elsewhere, with its parts and with what stands on them.
void move_item(Scene& scene, std::size_t item, const Vector3& position, double yaw);

/// @throws Error naming every value outside its range, those of the items and their loads included.
void validate(const Scene& scene);

}  // namespace gurney
