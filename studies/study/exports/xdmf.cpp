#include "studies/study/exports/xdmf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/vector.h"
#include "studies/study/results/hdf5_reader.h"
#include "studies/study/results/hdf5_writer.h"

namespace gurney::study {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Codes of cells in a mixed topology of XDMF.
constexpr std::int64_t kVertices = 1, kPolygon = 3, kQuadrilateral = 5, kHexahedron = 9;

struct Shape {
  std::size_t item = kNone;   ///< none: the room
  std::size_t wheel = kNone;  ///< column of the swivel angles; none: no caster
  std::string kind;
  Vector3 pivot;
  std::vector<Vector3> points;  ///< in the axes of the body
};

Vector3 vector_at(const std::vector<double>& numbers, std::size_t row) {
  return {numbers[3 * row], numbers[3 * row + 1], numbers[3 * row + 2]};
}

void require_values(const Hdf5Reader& file, const char* name, const std::vector<double>& values,
                    std::size_t count) {
  require(values.size() == count, fmt::format("{}: {} has {} values; must have {}", file.path(),
                                              name, values.size(), count));
}

std::size_t index_in(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? kNone : static_cast<std::size_t>(found - names.begin());
}

std::vector<Shape> shapes_of(const Hdf5Reader& file, const std::vector<std::string>& items) {
  const auto names = file.strings("/shapes/item"), bodies = file.strings("/shapes/body"),
             kinds = file.strings("/shapes/kind"), wheels = file.strings("/histories/wheel");
  const auto first = file.numbers("/shapes/first"), count = file.numbers("/shapes/count"),
             pivots = file.numbers("/shapes/pivot"), points = file.numbers("/shapes/point");
  file.require_length({"/shapes/item", "/shapes/body", "/shapes/first", "/shapes/count"},
                      kinds.size());
  require_values(file, "/shapes/pivot", pivots, 3 * kinds.size());
  const double vertices = std::floor(static_cast<double>(points.size()) / 3);
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    require(first[i] >= 0 && count[i] >= 0 && first[i] + count[i] <= vertices,
            fmt::format("{}: /shapes: shape {} has the points {} to {} of {}", file.path(), i,
                        first[i], first[i] + count[i], vertices));
    Shape shape;
    shape.kind = kinds[i];
    shape.pivot = vector_at(pivots, i);
    if (!names[i].empty()) {
      shape.item = index_in(items, names[i]);
      shape.wheel = index_in(wheels, items.size() == 1 ? bodies[i] : names[i] + "/" + bodies[i]);
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(count[i]); ++k)
      shape.points.push_back(vector_at(points, static_cast<std::size_t>(first[i]) + k));
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

/// The cells of all shapes, and the item of each.
struct Cells {
  std::vector<std::int64_t> connectivity, items;

  void add(const Shape& shape, std::int64_t first) {
    const auto points = static_cast<std::int64_t>(shape.points.size());
    if (shape.kind == "box") {
      begin(shape, {kHexahedron});
      for (std::int64_t i = 0; i < points; ++i) connectivity.push_back(first + i);
    } else if (shape.kind == "prism") {
      const std::int64_t sides = points / 2;
      for (std::int64_t i = 0; i < sides; ++i) {
        const std::int64_t next = (i + 1) % sides;
        begin(shape,
              {kQuadrilateral, first + i, first + next, first + sides + next, first + sides + i});
      }
      for (const std::int64_t ring : {first, first + sides}) {
        begin(shape, {kPolygon, sides});
        for (std::int64_t i = 0; i < sides; ++i) connectivity.push_back(ring + i);
      }
    } else {
      begin(shape, {kVertices, points});
      for (std::int64_t i = 0; i < points; ++i) connectivity.push_back(first + i);
    }
  }

 private:
  void begin(const Shape& shape, std::initializer_list<std::int64_t> numbers) {
    connectivity.insert(connectivity.end(), numbers);
    items.push_back(shape.item == kNone ? -1 : static_cast<std::int64_t>(shape.item));
  }
};

/// Where the items are at each time.
class Poses {
 public:
  explicit Poses(const Hdf5Reader& file)
      : items_(file.strings("/histories/item").size()),
        wheels_(file.strings("/histories/wheel").size()),
        start_(file.numbers("/histories/start")),
        displacement_(file.numbers("/histories/displacement")),
        orientation_(file.numbers("/histories/orientation")),
        swivel_(wheels_ == 0 ? std::vector<double>() : file.numbers("/histories/swivel_angle")) {}

  /// @throws Error unless there is a pose of each item and wheel at each time
  void require_times(const Hdf5Reader& file, std::size_t times) const {
    require_values(file, "/histories/start", start_, 3 * items_);
    require_values(file, "/histories/displacement", displacement_, 3 * items_ * times);
    require_values(file, "/histories/orientation", orientation_, 4 * items_ * times);
    require_values(file, "/histories/swivel_angle", swivel_, wheels_ * times);
  }

  Vector3 place(const Shape& shape, Vector3 point, std::size_t time) const {
    if (shape.item == kNone) return point;
    if (shape.wheel != kNone) {
      const double heading = swivel_[time * wheels_ + shape.wheel];
      point = Eigen::AngleAxisd(heading, Vector3::UnitZ()) * point;
    }
    const std::size_t row = time * items_ + shape.item;
    const double* const q = &orientation_[4 * row];
    return vector_at(start_, shape.item) + vector_at(displacement_, row) +
           Quaternion(q[0], q[1], q[2], q[3]) * (shape.pivot + point);
  }

 private:
  std::size_t items_, wheels_;
  std::vector<double> start_, displacement_, orientation_, swivel_;
};

std::string data_item(const std::string& file, const std::string& path, const char* type,
                      const std::string& dimensions) {
  return fmt::format(
      "<DataItem Format=\"HDF\" NumberType=\"{}\" Precision=\"8\" Dimensions=\"{}\">{}:{}"
      "</DataItem>",
      type, dimensions, file, path);
}

}  // namespace

void export_xdmf(const std::string& path, const std::string& name, const TakeFile& take) {
  const Hdf5Reader file(path);
  require(file.text_attribute("filetype") == "gurney-results",
          path + ": holds many runs; make the one to be seen with gurney replay, and export that");
  const std::vector<double> time = file.numbers("/histories/time");
  require(!time.empty(), path + ": has no histories (settings.history_step_s)");
  const std::vector<Shape> shapes = shapes_of(file, file.strings("/histories/item"));
  const Poses poses(file);
  poses.require_times(file, time.size());

  Cells cells;
  std::vector<std::int64_t> vertices, places, cell_rows;
  for (const Shape& shape : shapes) {
    cells.add(shape, static_cast<std::int64_t>(vertices.size()));
    for (std::size_t i = 0; i < shape.points.size(); ++i)
      vertices.push_back(static_cast<std::int64_t>(vertices.size()));
  }
  for (std::size_t i = 0; i < cells.connectivity.size(); ++i)
    places.push_back(static_cast<std::int64_t>(i));
  for (std::size_t i = 0; i < cells.items.size(); ++i)
    cell_rows.push_back(static_cast<std::int64_t>(i));

  Hdf5Writer points;
  points.add_scale({"/place", "1", "place in the list of cells", {}}, places);
  points.add_scale({"/cell", "1", "index of the cell", {}}, cell_rows);
  points.add_scale({"/vertex", "1", "index of the point", {}}, vertices);
  points.add_scale({"/axis", "1", "floor axis", {}}, std::vector<std::string>{"x", "y", "z"});
  points.add({"/cells", "1", "mixed topology of XDMF 3", {"/place"}}, cells.connectivity);
  points.add({"/item", "1", "index of the item; -1: the room", {"/cell"}}, cells.items);
  points.add_group("/points");

  const std::string heavy = name + "_shapes.h5";
  const std::string topology = fmt::format(
      "<Topology TopologyType=\"Mixed\" NumberOfElements=\"{}\">{}</Topology>", cells.items.size(),
      data_item(heavy, "/cells", "Int", std::to_string(places.size())));
  const std::string attribute = fmt::format(
      "<Attribute Name=\"item\" AttributeType=\"Scalar\" Center=\"Cell\">{}</Attribute>",
      data_item(heavy, "/item", "Int", std::to_string(cells.items.size())));
  std::string xml =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
      "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t t = 0; t < time.size(); ++t) {
    std::vector<double> all;
    for (const Shape& shape : shapes)
      for (const Vector3& point : shape.points) {
        const Vector3 placed = poses.place(shape, point, t);
        all.insert(all.end(), placed.data(), placed.data() + 3);
      }
    const std::string dataset = fmt::format("/points/{:06}", t);
    points.add({dataset, "m", "points in floor axes", {"/vertex", "/axis"}}, all);
    xml += fmt::format(
        "<Grid Name=\"shapes\" GridType=\"Uniform\"><Time Value=\"{}\"/>{}"
        "<Geometry GeometryType=\"XYZ\">{}</Geometry>{}</Grid>\n",
        time[t], topology, data_item(heavy, dataset, "Float", fmt::format("{} 3", vertices.size())),
        attribute);
  }
  take(heavy, points.image());
  take(name + ".xdmf", xml + "</Grid>\n</Domain>\n</Xdmf>\n");
}

}  // namespace gurney::study
