#pragma once

#include <string>
#include <vector>

#include "engine/config/table.h"
#include "engine/scene/room.h"
#include "equipment/catalogue/assumption.h"
#include "equipment/catalogue/contact_table.h"
#include "equipment/catalogue/unique_names.h"

namespace gurney::equipment {

/// A named place, such as a socket: where tethers end.
struct RoomPoint {
  std::string name;
  Vector3 position = Vector3::Zero();  ///< [m]
};

/// What stands still around the items (docs/formats/room_file.md).
struct RoomDescription {
  std::vector<RoomShape> shapes;
  std::vector<Zone> zones;
  std::vector<RoomPoint> points;
  std::vector<MaterialContact> contacts;  ///< stated for this room; usual_contacts() come after
  std::vector<Assumption> assumptions;
};

/// Names of a scene: those of shapes are shared with the items.
struct RoomNames {
  UniqueNames shapes, zones, points;
};

/// Appends the keys of a room. Errors are noted in the table's document; the result is for use
/// only after its `finish`.
void read_room(config::Table table, RoomNames& names, Uncertain<RoomDescription>& room);

/// Appends a file of its own, drawn as the part "room".
/// @throws Error with every error of the file; what could be read is there.
/// @return its name
std::string load_room(const std::string& file, RoomNames& names, Uncertain<RoomDescription>& room);

}  // namespace gurney::equipment
