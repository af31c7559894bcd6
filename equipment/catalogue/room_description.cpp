#include "equipment/catalogue/room_description.h"

#include "engine/base/units.h"
#include "equipment/catalogue/room_parts.h"

namespace gurney::equipment {
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
  known.insert(known.end(), usual.begin(), usual.end());

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
