#include "equipment/catalogue/room_description.h"

#include "engine/base/units.h"
#include "equipment/catalogue/room_parts.h"

namespace gurney::equipment {
namespace {

using config::Range;
using config::Table;

Quaternion about_z(double angle) { return Quaternion(Eigen::AngleAxisd(angle, Vector3::UnitZ())); }

RoomShape read_box(Quantities& in) {
  RoomShape shape;
  shape.position = in.vector("center_m", Range::any());
  shape.rotation = about_z(in.number("yaw_deg", Range::any(), 0.0) * kRadiansPerDegree);
  shape.shape = RoomBox{in.vector("size_m", Range::positive())};
  return shape;
}

RoomShape read_column(Quantities& in) {
  const Vector2 center = read_plan_point(in, "center_m");
  const RoomColumn column{in.number("radius_m", Range::positive()),
                          in.number("height_m", Range::positive())};
  RoomShape shape;
  shape.position = Vector3(center.x(), center.y(), 0.5 * column.height);
  shape.shape = column;
  return shape;
}

RoomShape read_low_box(Quantities& in) {
  const PlanLine line = read_plan_line(in);
  const double width = in.number("width_m", Range::positive());
  return box_along(line, 0, line.length(), width, 0, in.number("height_m", Range::positive()));
}

Zone read_zone(Quantities in, const std::string& name) {
  Zone zone;
  zone.name = name;
  zone.center = read_plan_point(in, "center_m");
  zone.length = in.number("length_m", Range::positive());
  zone.width = in.number("width_m", Range::positive());
  zone.angle = in.number("yaw_deg", Range::any(), 0.0) * kRadiansPerDegree;
  return zone;
}

struct ShapeKind {
  const char* key;
  const char* material;
  RoomShape (*read)(Quantities&);
};
constexpr ShapeKind kShapes[] = {{"box", "wood", read_box},
                                 {"column", "concrete", read_column},
                                 {"kerb", "concrete", read_low_box},
                                 {"threshold", "steel", read_low_box}};

}  // namespace

void read_room(Table table, RoomNames& names, RoomDescription& room) {
  std::vector<MaterialContact> contacts = read_contacts(table);
  room.contacts.insert(room.contacts.begin(), contacts.begin(), contacts.end());
  std::vector<MaterialContact> known = room.contacts;
  const std::vector<MaterialContact> usual = usual_contacts();
  known.insert(known.end(), usual.begin(), usual.end());

  read_walls(table, known, names, room);
  for (const ShapeKind& kind : kShapes) {
    std::size_t index = 0;
    for (Table& each : table.tables(kind.key)) {
      Quantities in(each, room.assumptions);
      const std::string name = names.shapes.read(each, kind.key, index++);
      RoomShape shape = kind.read(in);
      shape.name = name;
      shape.material = read_material(each, known, kind.material);
      room.shapes.push_back(std::move(shape));
    }
  }
  std::size_t index = 0;
  for (Table& each : table.tables("zone")) {
    const std::string name = names.zones.read(each, "zone", index++);
    room.zones.push_back(read_zone(Quantities(each, room.assumptions), name));
  }
  index = 0;
  for (Table& each : table.tables("point")) {
    Quantities in(each, room.assumptions);
    const std::string name = names.points.read(each, "point", index++);
    room.points.push_back({name, in.vector("position_m", Range::any())});
  }
}

std::string load_room(const std::string& file, const std::optional<Draw>& draw, RoomNames& names,
                      RoomDescription& room) {
  config::Document document(file);
  if (draw) document.set_draw(draw->of_part("room"));
  Table root = document.root();
  root.choice("schema", {"gurney-room/1"});
  const std::string name = root.text("name");
  root.text("description", "");
  read_room(root, names, room);
  document.finish();
  return name;
}

}  // namespace gurney::equipment
