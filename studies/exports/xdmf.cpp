#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/vector.h"
#include "studies/exports/export.h"
#include "studies/results/hdf5_reader.h"
#include "studies/results/hdf5_writer.h"

namespace gurney::study {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Codes of cells in a mixed topology of XDMF.
constexpr std::int64_t kVertex = 1, kTriangle = 4, kQuadrilateral = 5, kHexahedron = 9;

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

/// The cells of shapes, and the item of each. Cells of a fixed number of points only: readers such
/// as meshio know no polygons.
struct Cells {
  std::vector<std::int64_t> connectivity, items;
  std::int64_t points = 0;

  void add(const Shape& shape) {
    const std::int64_t first = points;
    points += static_cast<std::int64_t>(shape.points.size());
    if (shape.kind == "box") {
      begin(shape, {kHexahedron});
      for (std::int64_t i = first; i < points; ++i) connectivity.push_back(i);
    } else if (shape.kind == "prism") {
      add_prism(shape, first, static_cast<std::int64_t>(shape.points.size()) / 2);
    } else {
      for (std::int64_t i = first; i < points; ++i) begin(shape, {kVertex, 1, i});
    }
  }

 private:
  void add_prism(const Shape& shape, std::int64_t first, std::int64_t sides) {
    for (std::int64_t i = 0; i < sides; ++i) {
      const std::int64_t next = (i + 1) % sides;
      begin(shape,
            {kQuadrilateral, first + i, first + next, first + sides + next, first + sides + i});
    }
    for (const std::int64_t ring : {first, first + sides}) {  // a fan from its first point
      std::int64_t i = 1;
      for (; i + 2 < sides; i += 2)
        begin(shape, {kQuadrilateral, ring, ring + i, ring + i + 1, ring + i + 2});
      if (i + 1 < sides) begin(shape, {kTriangle, ring, ring + i, ring + i + 1});
    }
  }

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

std::vector<std::int64_t> counted(std::size_t count) {
  std::vector<std::int64_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// Shapes whose points are written together, in the file of points below `group`.
class ShapeGrid {
 public:
  ShapeGrid(std::string name, std::string heavy, Hdf5Writer& points)
      : name_(std::move(name)), heavy_(std::move(heavy)), points_(points) {}

  void add(const Shape& shape) {
    shapes_.push_back(&shape);
    cells_.add(shape);
  }
  bool empty() const { return shapes_.empty(); }

  void write_cells() {
    const std::string at = "/" + name_;
    points_.add_group(at);
    points_.add_scale({at + "/place", "1", "place in the list of cells", {}},
                      counted(cells_.connectivity.size()));
    points_.add_scale({at + "/cell", "1", "index of the cell", {}}, counted(cells_.items.size()));
    points_.add_scale({at + "/vertex", "1", "index of the point", {}},
                      counted(static_cast<std::size_t>(cells_.points)));
    points_.add({at + "/cells", "1", "mixed topology of XDMF 3", {at + "/place"}},
                cells_.connectivity);
    points_.add({at + "/item", "1", "index of the item; -1: the room", {at + "/cell"}},
                cells_.items);
    points_.add_group(at + "/points");
  }

  /// Path of the points at one time.
  std::string write_points(const Poses& poses, std::size_t time) {
    std::vector<double> all;
    for (const Shape* shape : shapes_)
      for (const Vector3& point : shape->points) {
        const Vector3 placed = poses.place(*shape, point, time);
        all.insert(all.end(), placed.data(), placed.data() + 3);
      }
    const std::string path = fmt::format("/{}/points/{:06}", name_, time);
    points_.add({path, "m", "points in floor axes", {"/" + name_ + "/vertex", "/axis"}}, all);
    return path;
  }

  std::string xml(const std::string& points) const {
    const auto item = [&](const std::string& path, const char* type, const std::string& dims) {
      return data_item(heavy_, path, type, dims);
    };
    const std::string cells = std::to_string(cells_.items.size());
    return fmt::format(
        "<Grid Name=\"{}\" GridType=\"Uniform\">"
        "<Topology TopologyType=\"Mixed\" NumberOfElements=\"{}\">{}</Topology>"
        "<Geometry GeometryType=\"XYZ\">{}</Geometry>"
        "<Attribute Name=\"item\" AttributeType=\"Scalar\" Center=\"Cell\">{}</Attribute></Grid>",
        name_, cells,
        item("/" + name_ + "/cells", "Int", std::to_string(cells_.connectivity.size())),
        item(points, "Float", fmt::format("{} 3", cells_.points)),
        item("/" + name_ + "/item", "Int", cells));
  }

 private:
  std::string name_, heavy_;
  Hdf5Writer& points_;
  std::vector<const Shape*> shapes_;
  Cells cells_;
};

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

  const std::string heavy = name + "_shapes.h5";
  Hdf5Writer points;
  points.add_scale({"/axis", "1", "floor axis", {}}, std::vector<std::string>{"x", "y", "z"});
  ShapeGrid items("items", heavy, points), room("room", heavy, points);
  for (const Shape& shape : shapes) (shape.item == kNone ? room : items).add(shape);
  items.write_cells();
  // The room stands: its points are written once, and each time names them.
  std::string standing;
  if (!room.empty()) {
    room.write_cells();
    standing = room.xml(room.write_points(poses, 0));
  }
  std::string xml =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
      "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t t = 0; t < time.size(); ++t)
    xml += fmt::format(
        "<Grid Name=\"shapes\" GridType=\"Collection\" CollectionType=\"Spatial\">"
        "<Time Value=\"{}\"/>{}{}</Grid>\n",
        time[t], items.xml(items.write_points(poses, t)), standing);
  take(heavy, points.image());
  take(name + ".xdmf", xml + "</Grid>\n</Domain>\n</Xdmf>\n");
}

}  // namespace gurney::study
