#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "engine/config/table.h"
#include "engine/scene/room.h"
#include "equipment/catalogue/assumption.h"
#include "equipment/catalogue/contact_table.h"
#include "equipment/catalogue/quantity.h"

namespace gurney::equipment {

/// Names that must differ from each other, and from "floor", which events use.
class UniqueNames {
 public:
  bool has(const std::string& name) const { return taken_.contains(name); }

  /// Takes `name` for the table; a name that is empty, "floor" or taken is noted at its key `name`.
  void take(config::Table& table, const std::string& name);

  /// The key `name`, or `kind 2` where it is absent, and takes it.
  std::string read(config::Table& table, const std::string& kind, std::size_t index);

 private:
  std::map<std::string, std::string> taken_;  ///< and where
};

/// A named place, such as a socket: where tethers end.
struct RoomPoint {
  std::string name;
  Vector3 position = Vector3::Zero();  ///< [m]
};

/// Fixed surroundings of the items (docs/formats/room_file.md).
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

/// A point in plan, x and y [m]; noted where it is missing.
std::array<StatedQuantity, 2> read_plan_point(Quantities& in, const std::string& key);

/// A line in plan from `from_m` to `to_m`; one of no length is noted.
struct PlanLine {
  Vector2 from = Vector2::Zero();
  Vector2 to = Vector2::UnitX();
  double length() const { return (to - from).norm(); }
};
Uncertain<PlanLine> read_plan_line(Quantities& in);

/// The box along part of a line, `begin` to `end` from its start, `low` to `high` above the floor.
RoomShape box_along(const PlanLine& line, double begin, double end, double width, double low,
                    double high);

/// The key `material`; one that no contact names is noted.
std::string read_material(config::Table& table, const std::vector<MaterialContact>& contacts,
                          const std::string& fallback);

/// The tables [[wall]] of a room with their doors, as boxes beside and above them.
/// @param known  contacts whose materials a wall may have
void read_walls(config::Table& room, const std::vector<MaterialContact>& known, RoomNames& names,
                Uncertain<RoomDescription>& result);

}  // namespace gurney::equipment
