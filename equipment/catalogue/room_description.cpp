#include "equipment/catalogue/room_description.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/append_all.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"

namespace gurney::equipment {

void UniqueNames::take(config::Table& table, const std::string& name) {
  const std::string stated = table.has("name") ? fmt::format(" = \"{}\"", name)
                                               : fmt::format(": not given, so it is '{}'", name);
  if (name.empty() || name == "floor")
    table.note("name", stated + ": must not be empty or 'floor'");
  else if (const auto [known, is_new] = taken_.emplace(name, table.where("name")); !is_new)
    table.note("name", stated + ": must differ from the name at " + known->second);
}

std::string UniqueNames::read(config::Table& table, const std::string& kind, std::size_t index) {
  const std::string name = table.text("name", fmt::format("{} {}", kind, index + 1));
  take(table, name);
  return name;
}

using config::Range;
using config::Table;

std::array<StatedQuantity, 2> read_plan_point(Quantities& in, const std::string& key) {
  if (!in.table().has(key)) in.table().note(key, ": missing; must be an array of 2 numbers");
  return in.plane(key, Range::any());
}

Uncertain<PlanLine> read_plan_line(Quantities& in) {
  config::Document& document = in.table().document();
  const std::size_t errors = document.errors();
  Uncertain<PlanLine> line;
  line.set(&PlanLine::from, read_plan_point(in, "from_m"));
  line.set(&PlanLine::to, read_plan_point(in, "to_m"));
  if (document.errors() > errors) return Uncertain<PlanLine>();
  line.add(document, [to = in.table().spot("to_m")](PlanLine& of_draw, Sampler& of) {
    if (of_draw.length() > 0) return;
    of.error(to, ": must differ from from_m");
    of_draw = PlanLine();
  });
  return line;
}

RoomShape box_along(const PlanLine& line, double begin, double end, double width, double low,
                    double high) {
  const Vector2 along = (line.to - line.from) / line.length();
  const Vector2 middle = line.from + 0.5 * (begin + end) * along;
  RoomShape shape;
  shape.position = Vector3(middle.x(), middle.y(), 0.5 * (low + high));
  shape.rotation = Eigen::AngleAxisd(std::atan2(along.y(), along.x()), Vector3::UnitZ());
  shape.shape = RoomBox{Vector3(end - begin, width, high - low)};
  return shape;
}

std::string read_material(Table& table, const std::vector<MaterialContact>& contacts,
                          const std::string& fallback) {
  const std::string material = table.text("material", fallback);
  if (!table.is_text("material")) return fallback;
  const std::vector<std::string> known = materials_in(contacts);
  for (const std::string& each : known)
    if (each == material) return material;
  table.note("material", " = \"" + material + "\": no contact names this material" +
                             config::suggestion(material, known));
  return fallback;
}

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

namespace {

using config::Range;
using config::Table;

Quaternion about_z(double angle) { return Quaternion(Eigen::AngleAxisd(angle, Vector3::UnitZ())); }

Uncertain<RoomShape> read_box(Quantities& in) {
  Uncertain<RoomShape> shape;
  shape.set(&RoomShape::position, in.vector("center_m", Range::any()));
  shape.add([yaw = in.angle_deg("yaw_deg", Range::any(), 0.0),
             size = in.vector("size_m", Range::positive())](RoomShape& box, Sampler& of) {
    box.rotation = about_z(of(yaw));
    box.shape = RoomBox{of(size)};
  });
  return shape;
}

Uncertain<RoomShape> read_column(Quantities& in) {
  Uncertain<RoomShape> shape;
  shape.set(&RoomShape::position, read_plan_point(in, "center_m"));
  shape.add([radius = in.number("radius_m", Range::positive()),
             height = in.number("height_m", Range::positive())](RoomShape& column, Sampler& of) {
    const RoomColumn size{of(radius), of(height)};
    column.position.z() = 0.5 * size.height;
    column.shape = size;
  });
  return shape;
}

Uncertain<RoomShape> read_low_box(Quantities& in) {
  Uncertain<RoomShape> shape;
  shape.add([line = read_plan_line(in), width = in.number("width_m", Range::positive()),
             height = in.number("height_m", Range::positive())](RoomShape& box, Sampler& of) {
    const PlanLine middle = line.sample(of);
    const double across = of(width);
    box = box_along(middle, 0, middle.length(), across, 0, of(height));
  });
  return shape;
}

Uncertain<Zone> read_zone(Quantities in, const std::string& name) {
  Zone fixed;
  fixed.name = name;
  Uncertain<Zone> zone(std::move(fixed));
  zone.set(&Zone::center, read_plan_point(in, "center_m"));
  zone.set(&Zone::length, in.number("length_m", Range::positive()));
  zone.set(&Zone::width, in.number("width_m", Range::positive()));
  zone.set(&Zone::angle, in.angle_deg("yaw_deg", Range::any(), 0.0));
  return zone;
}

struct ShapeKind {
  const char* key;
  const char* material;
  Uncertain<RoomShape> (*read)(Quantities&);
};
constexpr ShapeKind kShapes[] = {{"box", "wood", read_box},
                                 {"column", "concrete", read_column},
                                 {"kerb", "concrete", read_low_box},
                                 {"threshold", "steel", read_low_box}};

}  // namespace

void read_room(Table table, RoomNames& names, Uncertain<RoomDescription>& room) {
  room.add([contacts = read_contacts(table)](RoomDescription& of_draw, Sampler& of) {
    const std::vector<MaterialContact> stated = contacts.sample(of);
    of_draw.contacts.insert(of_draw.contacts.begin(), stated.begin(), stated.end());
  });
  std::vector<MaterialContact> known = room.stated().contacts;
  const std::vector<MaterialContact> usual = usual_contacts().stated();
  append_all(known, usual);

  read_walls(table, known, names, room);
  for (const ShapeKind& kind : kShapes) {
    std::size_t index = 0;
    for (Table& each : table.tables(kind.key)) {
      Quantities in(each);
      const std::string name = names.shapes.read(each, kind.key, index++);
      Uncertain<RoomShape> shape = kind.read(in);
      shape.add([name, material = read_material(each, known, kind.material)](RoomShape& of_draw,
                                                                             Sampler&) {
        of_draw.name = name;
        of_draw.material = material;
      });
      room.append(&RoomDescription::shapes, std::move(shape));
    }
  }
  std::size_t index = 0;
  for (Table& each : table.tables("zone")) {
    const std::string name = names.zones.read(each, "zone", index++);
    room.append(&RoomDescription::zones, read_zone(Quantities(each), name));
  }
  index = 0;
  for (Table& each : table.tables("point")) {
    Uncertain<RoomPoint> point(
        RoomPoint{names.points.read(each, "point", index++), Vector3::Zero()});
    point.set(&RoomPoint::position, Quantities(each).vector("position_m", Range::any()));
    room.append(&RoomDescription::points, std::move(point));
  }
}

std::string load_room(const std::string& file, RoomNames& names, Uncertain<RoomDescription>& room) {
  config::Document document(file);
  Table root = document.root();
  root.choice("schema", {"gurney-room/1"});
  const std::string name = root.text("name");
  root.text("description", "");
  Uncertain<RoomDescription> of_file;
  read_room(root, names, of_file);
  room.add([of_file](RoomDescription& of_draw, Sampler& of) {
    of_file.apply(of_draw, of.of_part("room"));
  });
  document.finish();
  return name;
}

}  // namespace gurney::equipment
