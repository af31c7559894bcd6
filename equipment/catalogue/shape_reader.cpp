#include "equipment/catalogue/shape_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "engine/base/units.h"
#include "engine/bullet/hull_corners.h"
#include "engine/contact/body_form.h"
#include "equipment/catalogue/mesh_file.h"

namespace gurney::equipment {
namespace {

using config::Range;
using config::Table;
using Solids = std::vector<BodyShape>;

constexpr std::size_t kMany = 100;  // corners that a hull may be tried with one by one
constexpr double kSmallest = 1e-3, kLargest = 20;  // [m] of a mesh
constexpr double kThinnest = 3e-4;                 // part of a hull's size

const std::vector<std::string> kSolidKinds = {"box", "cylinder", "sphere", "hull", "mesh"};

struct Hull {
  std::vector<Vector3> corners;
  std::string problem;  ///< empty: none
};

Hull hull_of(const std::vector<Vector3>& points) {
  const std::string flat = "the points span no volume: they lie in a plane, or nearly so";
  Hull hull;
  if (points.size() > kMany) {
    hull.corners = hull_corners(points);
  } else {
    for (const Vector3& point : points)  // of a mesh, each as often as it is in triangles
      if (std::ranges::find(hull.corners, point) == hull.corners.end())
        hull.corners.push_back(point);
  }
  if (!spans_a_volume(hull.corners)) return {{}, flat};
  const auto too_many = [](std::size_t count) {
    return fmt::format(
        "its hull has {} corners: must be at most {}; take fewer points, a coarser mesh, a "
        "cylinder or a sphere",
        count, SolidHull::kMaxCorners);
  };
  if (hull.corners.size() > 3 * kMany) return {{}, too_many(hull.corners.size())};
  const ConvexShape shape = convex_body(hull.corners);
  double size = 0, width = std::numeric_limits<double>::infinity();
  for (const Vector3& corner : shape.corners)
    size = std::max(size, (corner - shape.corners.front()).norm());
  for (const ConvexShape::Face& face : shape.faces)
    width = std::min(width, shape.level(face) - shape.lowest(face.normal));
  if (!(width > kThinnest * size)) return {{}, flat};
  hull.corners = corners_of(shape);
  if (hull.corners.size() > SolidHull::kMaxCorners) return {{}, too_many(hull.corners.size())};
  return hull;
}

/// Where the origin of a hull or a mesh is.
void move_to_place(Quantities& in, bool placed, Uncertain<Solids>& solids) {
  if (!placed || !in.table().has("position_mm")) return;
  solids.add([place = in.vector_mm("position_mm", Range::any())](Solids& of_draw, Sampler& of) {
    const Vector3 by = of(place);
    for (BodyShape& shape : of_draw) shape.center += by;
  });
}

Solids read_hull(Table& table) {
  std::vector<Vector3> points = table.vectors("points_mm", Range::any());
  for (Vector3& point : points) point /= kMillimetersPerMeter;
  if (points.empty()) return {};
  const Hull hull = hull_of(points);
  if (hull.problem.empty()) return {hull_shape(hull.corners)};
  table.note("points_mm", ": " + hull.problem);
  return {};
}

Solids read_mesh_shape(Table& table) {
  const std::vector<std::string> units = {"mm", "cm", "m", "in"};
  const std::vector<double> sizes = {1e-3, 1e-2, 1, 0.0254};
  const std::string name = table.text("file");
  const std::size_t unit = table.choice("unit", units);
  const auto refuse = [&](const std::string& why) {
    table.note("file", " = \"" + name + "\": " + why);
    return Solids{};
  };
  if (name.empty()) return {};
  Solids solids;
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  try {
    const auto path = std::filesystem::path(table.document().path()).parent_path() / name;
    std::vector<MeshObject> objects = read_mesh(path.lexically_normal().string());
    for (MeshObject& object : objects)
      for (Vector3& point : object.points) {
        point *= sizes[unit];
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
      }
    const double largest = (high - low).maxCoeff();
    if (!(largest >= kSmallest && largest <= kLargest))
      return refuse(
          fmt::format("the mesh is {:.4g} m long in unit = \"{}\": must be {:g} to {:g} m", largest,
                      units[unit], kSmallest, kLargest));
    for (const MeshObject& object : objects) {
      const Hull hull = hull_of(object.points);
      if (!hull.problem.empty())
        return refuse((object.name.empty() ? "" : "object '" + object.name + "': ") + hull.problem);
      solids.push_back(hull_shape(hull.corners));
    }
  } catch (const Error& error) {
    return refuse(error.what());
  }
  return solids;
}

/// A box, a cylinder or a sphere, whose sizes a draw may change.
Uncertain<BodyShape> read_round_or_box(Quantities& in, const std::string& kind) {
  Uncertain<BodyShape> shape;
  if (kind == "box") {
    shape.set(&BodyShape::size, in.vector_mm("size_mm", Range::positive()));
  } else if (kind == "sphere") {
    shape.add(
        [radius = in.length_mm("radius_mm", Range::positive())](BodyShape& of_draw, Sampler& of) {
          of_draw = sphere_shape(of_draw.center, of(radius));
        });
  } else {
    shape.add(
        [axis = read_axis(in.table(), Vector3::UnitZ()),
         radius = in.length_mm("radius_mm", Range::positive()),
         length = in.length_mm("length_mm", Range::positive())](BodyShape& of_draw, Sampler& of) {
          const double drawn = of(radius);
          of_draw = cylinder_shape(of_draw.center, {axis, drawn, of(length)});
        });
  }
  return shape;
}

}  // namespace

Vector3 read_axis(Table& table, const std::optional<Vector3>& usual) {
  const std::size_t errors = table.document().errors();
  const Vector3 axis = table.vector("axis", Range::any(), usual);
  if (axis.norm() > 0) return axis.normalized();
  if (table.document().errors() == errors)
    table.note("axis", fmt::format(" = [{:g}, {:g}, {:g}]: must have a length", axis.x(), axis.y(),
                                   axis.z()));
  return Vector3::UnitZ();
}

bool is_round(Table& solid) {
  const std::string& kind = kSolidKinds[solid.choice("kind", kSolidKinds, 0)];
  return kind == "cylinder" || kind == "sphere";
}

bool has_round_shape(Table& owner) { return std::ranges::any_of(owner.tables("shape"), is_round); }

Uncertain<Solids> read_solid(Table& table, bool placed) {
  Quantities in(table);
  const std::string& kind = kSolidKinds[table.choice("kind", kSolidKinds, 0)];
  if (kind == "hull" || kind == "mesh") {
    Uncertain<Solids> solids(kind == "hull" ? read_hull(table) : read_mesh_shape(table));
    move_to_place(in, placed, solids);
    return solids;
  }
  Uncertain<BodyShape> shape;
  if (placed) shape.set(&BodyShape::center, in.vector_mm("center_mm", Range::any()));
  shape.add([solid = read_round_or_box(in, kind)](BodyShape& of_draw, Sampler& of) {
    const Vector3 center = of_draw.center;
    of_draw = solid.sample(of);
    of_draw.center = center;
  });
  Uncertain<Solids> solids;
  solids.add([shape](Solids& of_draw, Sampler& of) { of_draw = {shape.sample(of)}; });
  return solids;
}

}  // namespace gurney::equipment
