#include "studies/results/shapes.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "studies/results/names.h"

namespace gurney::study {
namespace {

constexpr int kSides = 16;  ///< of what is round

struct Shape {
  std::string item, body, kind;
  Vector3 pivot = Vector3::Zero();  ///< origin of its axes, in item axes; of the room: 0
  std::vector<Vector3> points;
};

/// Corners in the order of VTK's hexahedron: round the bottom, then round the top.
std::vector<Vector3> box_points(const Vector3& center, const Vector3& size) {
  std::vector<Vector3> points;
  for (const double z : {-0.5, 0.5})
    for (const Vector2& corner :
         {Vector2(-0.5, -0.5), Vector2(0.5, -0.5), Vector2(0.5, 0.5), Vector2(-0.5, 0.5)})
      points.push_back(center + size.cwiseProduct(Vector3(corner.x(), corner.y(), z)));
  return points;
}

/// Two rings round an axis.
std::vector<Vector3> ring_points(const Vector3& center, double radius, const Vector3& half_axis,
                                 const Vector3& across) {
  const Vector3 third = half_axis.normalized().cross(across);
  std::vector<Vector3> points;
  for (const double end : {-1.0, 1.0})
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSides;
      points.push_back(center + end * half_axis +
                       radius * (std::cos(angle) * across + std::sin(angle) * third));
    }
  return points;
}

std::vector<Shape> shapes_of(const PlacedItem& item, const std::string& name) {
  std::vector<Shape> shapes;
  for (const Box& box : item.model.shape)
    shapes.push_back({name, "chassis", "box", Vector3::Zero(), box_points(box.center, box.size)});
  const std::vector<std::string> casters = caster_names(item.model);
  for (std::size_t i = 0; i < casters.size(); ++i) {
    const Caster& caster = item.model.casters[i];
    const Vector3 center(-caster.trail, 0, -(caster.height - caster.wheel_radius));
    shapes.push_back({name, casters[i], "prism", caster.mount,
                      ring_points(center, caster.wheel_radius,
                                  0.5 * caster.wheel_width * Vector3::UnitY(), Vector3::UnitX())});
  }
  return shapes;
}

Shape shape_of(const RoomShape& room) {
  Shape shape{"", room.name, "", Vector3::Zero(), {}};
  if (const auto* box = std::get_if<RoomBox>(&room.shape)) {
    shape.kind = "box";
    shape.points = box_points(Vector3::Zero(), box->size);
  } else if (const auto* column = std::get_if<RoomColumn>(&room.shape)) {
    shape.kind = "prism";
    shape.points = ring_points(Vector3::Zero(), column->radius,
                               0.5 * column->height * Vector3::UnitZ(), Vector3::UnitX());
  } else {
    shape.kind = "hull";
    shape.points = std::get<RoomHull>(room.shape).points;
  }
  for (Vector3& point : shape.points) point = room.position + room.rotation * point;
  return shape;
}

}  // namespace

void add_shapes(Hdf5Writer& file, const Scene& scene) {
  std::vector<Shape> shapes;
  const std::vector<std::string> names = item_names(scene);
  for (std::size_t i = 0; i < names.size(); ++i)
    for (Shape& shape : shapes_of(scene.items[i], names[i])) shapes.push_back(std::move(shape));
  for (const RoomShape& room : scene.room) shapes.push_back(shape_of(room));

  std::vector<std::int64_t> rows, first, count, vertices;
  std::vector<std::string> items, bodies, kinds;
  std::vector<double> pivots, points;
  for (const Shape& shape : shapes) {
    rows.push_back(static_cast<std::int64_t>(rows.size()));
    first.push_back(static_cast<std::int64_t>(vertices.size()));
    count.push_back(static_cast<std::int64_t>(shape.points.size()));
    items.push_back(shape.item);
    bodies.push_back(shape.body);
    kinds.push_back(shape.kind);
    pivots.insert(pivots.end(), shape.pivot.data(), shape.pivot.data() + 3);
    for (const Vector3& point : shape.points) {
      vertices.push_back(static_cast<std::int64_t>(vertices.size()));
      points.insert(points.end(), point.data(), point.data() + 3);
    }
  }
  const std::vector<std::string> shape{"/shapes/shape"};
  file.add_group("/shapes");
  file.add_scale({"/shapes/shape", "1", "index of the shape", {}}, rows);
  file.add_scale({"/shapes/vertex", "1", "index of the point", {}}, vertices);
  file.add_scale({"/shapes/axis", "1", "axis of the body", {}},
                 std::vector<std::string>{"x", "y", "z"});
  file.add({"/shapes/item", "1", "name of the item; empty: the room", shape}, items);
  file.add({"/shapes/body", "1", "chassis, name of the caster, or of the room's shape", shape},
           bodies);
  file.add({"/shapes/kind", "1", "box, prism or hull", shape}, kinds);
  file.add({"/shapes/first", "1", "first of its points", shape}, first);
  file.add({"/shapes/count", "1", "number of its points", shape}, count);
  file.add({"/shapes/pivot",
            "m",
            "origin of the body's axes, in item axes",
            {"/shapes/shape", "/shapes/axis"}},
           pivots);
  file.add(
      {"/shapes/point", "m", "the points, in the body's axes", {"/shapes/vertex", "/shapes/axis"}},
      points);
}

}  // namespace gurney::study
