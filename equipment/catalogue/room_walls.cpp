#include <fmt/format.h>

#include <algorithm>

#include "equipment/catalogue/room_parts.h"

namespace gurney::equipment {
namespace {

using config::Range;
using config::Table;

constexpr double kShortest = 1e-6;  // [m] pieces of a wall below this are left out

struct Door {
  double begin = 0, width = 0, height = 0;
  double end() const { return begin + width; }
};

struct Wall {
  PlanLine line;
  double thickness = 0, height = 0;
  std::vector<Door> doors;
};

struct DoorSpots {
  config::Spot at, width, height;
};

/// The last door against the wall and the doors before it.
void check_last_door(const Wall& wall, const DoorSpots& spots, Sampler& of) {
  const Door& door = wall.doors.back();
  const double length = wall.line.length();
  if (door.width > length)
    of.error(spots.width, fmt::format(" = {:g}: the door is wider than the wall, {:g} m long",
                                      door.width, length));
  else if (door.end() > length + kShortest)
    of.error(spots.at, fmt::format(" = {:g}: the door would end at {:g} m, beyond the end of "
                                   "the wall at {:g} m",
                                   door.begin, door.end(), length));
  if (door.height > wall.height)
    of.error(spots.height, fmt::format(" = {:g}: must be at most the height of the wall, {:g}",
                                       door.height, wall.height));
  for (std::size_t i = 0; i + 1 < wall.doors.size(); ++i) {
    const Door& other = wall.doors[i];
    if (door.begin < other.end() && other.begin < door.end())
      of.error(spots.at, fmt::format(" = {:g}: the door, to {:g} m, overlaps the one from {:g} "
                                     "to {:g} m",
                                     door.begin, door.end(), other.begin, other.end()));
  }
}

void read_door(Table& table, Uncertain<Wall>& wall) {
  const std::size_t errors = table.document().errors();
  Quantities in(table);
  Uncertain<Door> door;
  door.set(&Door::begin, in.number("at_m", Range::not_negative()));
  door.set(&Door::width, in.number("width_m", Range::positive()));
  door.set(&Door::height, in.number("height_m", Range::positive()));
  wall.append(&Wall::doors, std::move(door));
  if (table.document().errors() > errors) return;
  const DoorSpots spots{table.spot("at_m"), table.spot("width_m"), table.spot("height_m")};
  wall.add(table.document(),
           [spots](Wall& of_draw, Sampler& of) { check_last_door(of_draw, spots, of); });
}

/// The boxes of a wall beside and above its doors.
std::vector<RoomShape> boxes_of(Wall wall, const std::string& name, const std::string& material) {
  std::vector<RoomShape> boxes;
  const auto add = [&](const std::string& piece, RoomShape shape) {
    shape.name = piece;
    shape.material = material;
    boxes.push_back(std::move(shape));
  };
  int pieces = 0, lintels = 0;
  double done = 0;
  const auto add_piece = [&](double end) {
    if (!(end - done > kShortest)) return;
    add(wall.doors.empty() ? name : fmt::format("{} {}", name, ++pieces),
        box_along(wall.line, done, end, wall.thickness, 0, wall.height));
  };
  std::ranges::sort(wall.doors, {}, &Door::begin);
  for (const Door& door : wall.doors) {
    add_piece(door.begin);
    if (wall.height - door.height > kShortest)
      add(fmt::format("{} lintel {}", name, ++lintels),
          box_along(wall.line, door.begin, door.end(), wall.thickness, door.height, wall.height));
    done = door.end();
  }
  add_piece(wall.line.length());
  return boxes;
}

void read_wall(Table& table, const std::string& name, const std::vector<MaterialContact>& known,
               RoomNames& names, Uncertain<RoomDescription>& result) {
  Quantities in(table);
  const std::size_t errors = table.document().errors();
  Uncertain<Wall> wall;
  wall.set(&Wall::line, read_plan_line(in));
  wall.set(&Wall::thickness, in.number("thickness_m", Range::positive()));
  wall.set(&Wall::height, in.number("height_m", Range::positive()));
  const std::string material = read_material(table, known, "plasterboard");
  if (table.document().errors() > errors) return table.set_aside("door");
  for (Table& door : table.tables("door")) read_door(door, wall);
  for (const RoomShape& box : boxes_of(wall.stated(), name, material))
    if (box.name != name) names.shapes.take(table, box.name);
  result.add([wall, name, material](RoomDescription& of_draw, Sampler& of) {
    for (RoomShape& box : boxes_of(wall.sample(of), name, material))
      of_draw.shapes.push_back(std::move(box));
  });
}

}  // namespace

void read_walls(Table& room, const std::vector<MaterialContact>& known, RoomNames& names,
                Uncertain<RoomDescription>& result) {
  std::size_t index = 0;
  for (Table& table : room.tables("wall")) {
    const std::string name = names.shapes.read(table, "wall", index++);
    read_wall(table, name, known, names, result);
  }
}

}  // namespace gurney::equipment
