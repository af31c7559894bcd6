#pragma once

#include <array>
#include <string>

#include "engine/scene/room.h"
#include "equipment/catalogue/quantity.h"
#include "equipment/catalogue/room_description.h"

namespace gurney::equipment {

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
