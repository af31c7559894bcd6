#include <fmt/format.h>

#include <algorithm>

#include "equipment/catalogue/room_parts.h"

namespace gurney::equipment {
namespace {

using config::Range;
using config::Table;

constexpr double kShortest = 1e-6;  // [m] pieces of a wall below this are left out

struct Door {
  double begin = 0, end = 0, height = 0;
};

/// The doors of a wall, in their order along it; those that do not fit are noted.
std::vector<Door> read_doors(Table& wall, double length, double wall_height,
                             std::vector<Assumption>& assumptions) {
  std::vector<Door> doors;
  for (Table& table : wall.tables("door")) {
    const std::size_t mistakes = table.document().mistakes();
    Quantities in(table, assumptions);
    const double at = in.number("at_m", Range::not_negative());
    const double width = in.number("width_m", Range::positive());
    const Door door{at, at + width, in.number("height_m", Range::positive())};
    if (table.document().mistakes() == mistakes) {
      if (width > length)
        table.note("width_m", fmt::format(" = {:g}: the door is wider than the wall, {:g} m long",
                                          width, length));
      else if (door.end > length + kShortest)
        table.note("at_m", fmt::format(" = {:g}: the door would end at {:g} m, beyond the end of "
                                       "the wall at {:g} m",
                                       at, door.end, length));
      if (door.height > wall_height)
        table.note("height_m", fmt::format(" = {:g}: must be at most the height of the wall, {:g}",
                                           door.height, wall_height));
      for (const Door& other : doors)
        if (door.begin < other.end && other.begin < door.end)
          table.note("at_m", fmt::format(" = {:g}: the door, to {:g} m, overlaps the one from {:g} "
                                         "to {:g} m",
                                         at, door.end, other.begin, other.end));
    }
    doors.push_back(door);
  }
  std::ranges::sort(doors, {}, &Door::begin);
  return doors;
}

void read_wall(Table& table, const std::string& name, const std::vector<MaterialContact>& known,
               RoomNames& names, RoomDescription& result) {
  Quantities in(table, result.assumptions);
  const std::size_t mistakes = table.document().mistakes();
  const PlanLine line = read_plan_line(in);
  const double thickness = in.number("thickness_m", Range::positive());
  const double height = in.number("height_m", Range::positive());
  const std::string material = read_material(table, known, "plasterboard");
  table.has("door");
  if (table.document().mistakes() > mistakes) return;
  const std::vector<Door> doors = read_doors(table, line.length(), height, result.assumptions);
  const auto add = [&](const std::string& piece, RoomShape shape) {
    shape.name = piece;
    shape.material = material;
    if (piece != name) names.shapes.take(table, piece);
    result.shapes.push_back(std::move(shape));
  };
  int pieces = 0, lintels = 0;
  double done = 0;
  const auto add_piece = [&](double end) {
    if (!(end - done > kShortest)) return;
    add(doors.empty() ? name : fmt::format("{} {}", name, ++pieces),
        box_along(line, done, end, thickness, 0, height));
  };
  for (const Door& door : doors) {
    add_piece(door.begin);
    if (height - door.height > kShortest)
      add(fmt::format("{} lintel {}", name, ++lintels),
          box_along(line, door.begin, door.end, thickness, door.height, height));
    done = door.end;
  }
  add_piece(line.length());
}

}  // namespace

void read_walls(Table& room, const std::vector<MaterialContact>& known, RoomNames& names,
                RoomDescription& result) {
  std::size_t index = 0;
  for (Table& table : room.tables("wall")) {
    const std::string name = names.shapes.read(table, "wall", index++);
    read_wall(table, name, known, names, result);
  }
}

}  // namespace gurney::equipment
