#include "studies/playback/gltf.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>

#include "studies/playback/page.h"

namespace gurney::playback {
namespace {

Vector3 middle_of(const std::vector<Vector3>& points) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

/// A shape is convex: its faces look away from its middle.
void add_triangle(std::vector<Vector3>& corners, const Vector3& middle, const Vector3& a,
                  const Vector3& b, const Vector3& c) {
  const bool outwards = (b - a).cross(c - a).dot(a - middle) >= 0;
  corners.insert(corners.end(), {a, outwards ? b : c, outwards ? c : b});
}

/// Two rings of corners, one after the other.
std::vector<Vector3> prism(const std::vector<Vector3>& points, const Vector3& middle) {
  const std::size_t n = points.size() / 2;
  std::vector<Vector3> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    add_triangle(corners, middle, points[i], points[j], points[n + j]);
    add_triangle(corners, middle, points[i], points[n + j], points[n + i]);
  }
  for (std::size_t i = 2; i < n; ++i) {
    add_triangle(corners, middle, points[0], points[i - 1], points[i]);
    add_triangle(corners, middle, points[n], points[n + i - 1], points[n + i]);
  }
  return corners;
}

/// Every triangle of three points that has all others on one side.
std::vector<Vector3> hull(const std::vector<Vector3>& points, const Vector3& middle) {
  constexpr double kFlat = 1e-9;  // [m2], [m]
  std::vector<Vector3> corners;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const Vector3 normal = (points[j] - points[i]).cross(points[k] - points[i]);
        if (normal.norm() < kFlat) continue;
        double low = 0, high = 0;
        for (const Vector3& point : points) {
          const double height = normal.normalized().dot(point - points[i]);
          low = std::min(low, height);
          high = std::max(high, height);
        }
        if (low > -kFlat || high < kFlat)
          add_triangle(corners, middle, points[i], points[j], points[k]);
      }
  return corners;
}

using Json = nlohmann::json;

constexpr int kFloat = 5126, kVertices = 34962;  // codes of componentType and target

/// The parts of a document as they are added.
class Document {
 public:
  Document() {
    json_ = {{"asset", {{"version", "2.0"}, {"generator", "gurney"}}},
             {"scene", 0},
             {"scenes", {{{"nodes", {0}}}}},
             {"animations",
              {{{"name", "run"}, {"samplers", Json::array()}, {"channels", Json::array()}}}}};
    for (const char* list : {"nodes", "meshes", "materials", "accessors", "bufferViews"})
      json_[list] = Json::array();
  }

  std::size_t add(const char* list, Json entry) {
    json_[list].push_back(std::move(entry));
    return json_[list].size() - 1;
  }

  std::size_t add_child(std::size_t parent, Json node) {
    const std::size_t child = add("nodes", std::move(node));
    json_["nodes"][parent]["children"].push_back(child);
    return child;
  }

  /// Numbers of vectors with `width` components, in single precision.
  std::size_t accessor(const std::vector<double>& numbers, std::size_t width,
                       bool vertices = false) {
    static const char* const kTypes[] = {"", "SCALAR", "", "VEC3", "VEC4"};
    Json view{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", 4 * numbers.size()}};
    if (vertices) view["target"] = kVertices;
    std::vector<float> low(width, INFINITY), high(width, -INFINITY);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto number = static_cast<float>(numbers[i]);
      low[i % width] = std::min(low[i % width], number);
      high[i % width] = std::max(high[i % width], number);
      const auto bits = std::bit_cast<std::uint32_t>(number);
      for (int shift = 0; shift < 32; shift += 8)
        bytes_.push_back(static_cast<std::uint8_t>(bits >> shift & 255u));
    }
    return add("accessors", {{"bufferView", add("bufferViews", std::move(view))},
                             {"componentType", kFloat},
                             {"count", numbers.size() / width},
                             {"type", kTypes[width]},
                             {"min", low},
                             {"max", high}});
  }

  void animate(std::size_t node, const char* path, std::size_t times,
               const std::vector<double>& numbers, std::size_t width) {
    Json& animation = json_["animations"][0];
    animation["samplers"].push_back(
        {{"input", times}, {"output", accessor(numbers, width)}, {"interpolation", "LINEAR"}});
    animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1},
                                     {"target", {{"node", node}, {"path", path}}}});
  }

  std::string text() {
    json_["buffers"] = {{{"byteLength", bytes_.size()},
                         {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}};
    return json_.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  }

 private:
  Json json_;
  std::vector<std::uint8_t> bytes_;
};

std::size_t add_material(Document& file, const char* name, const Vector3& color, double opacity) {
  Json material{{"name", name},
                {"doubleSided", true},
                {"pbrMetallicRoughness",
                 {{"baseColorFactor", {color.x(), color.y(), color.z(), opacity}},
                  {"metallicFactor", 0},
                  {"roughnessFactor", 0.7}}}};
  if (opacity < 1) material["alphaMode"] = "BLEND";
  return file.add("materials", std::move(material));
}

std::size_t add_mesh(Document& file, const std::vector<RecordedShape>& shapes,
                     std::size_t material) {
  std::vector<double> places, normals;
  for (const RecordedShape& shape : shapes) {
    const std::vector<Vector3> corners = triangles(shape);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t a = i / 3 * 3;
      const Vector3 normal =
          (corners[a + 1] - corners[a]).cross(corners[a + 2] - corners[a]).normalized();
      places.insert(places.end(), corners[i].data(), corners[i].data() + 3);
      normals.insert(normals.end(), normal.data(), normal.data() + 3);
    }
  }
  const std::size_t position = file.accessor(places, 3, true);
  const std::size_t normal = file.accessor(normals, 3, true);
  return file.add(
      "meshes",
      {{"primitives",
        {{{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}, {"material", material}}}}});
}

/// Quaternions x, y, z, w of turns about an axis.
std::vector<double> turns(const std::vector<double>& angles, const Vector3& axis) {
  std::vector<double> numbers;
  for (const double angle : angles) {
    const Vector3 v = std::sin(angle / 2) * axis;
    numbers.insert(numbers.end(), {v.x(), v.y(), v.z(), std::cos(angle / 2)});
  }
  return numbers;
}

void add_wheel(Document& file, std::size_t item, const RecordedWheel& wheel, std::size_t times,
               std::size_t material) {
  const Vector3 &p = wheel.pivot, &c = wheel.center;
  const std::size_t fork = file.add_child(
      item, {{"name", wheel.name + ", fork"}, {"translation", {p.x(), p.y(), p.z()}}});
  const std::size_t turning =
      file.add_child(fork, {{"name", wheel.name},
                            {"translation", {c.x(), c.y(), c.z()}},
                            {"mesh", add_mesh(file, {shape_of(wheel)}, material)}});
  file.animate(fork, "rotation", times, turns(wheel.swivel, Vector3::UnitZ()), 4);
  file.animate(turning, "rotation", times, turns(wheel.roll, Vector3::UnitY()), 4);
}

void add_item(Document& file, const RecordedItem& item, std::size_t times, std::size_t body,
              std::size_t rubber) {
  const std::size_t node =
      file.add_child(0, {{"name", item.name}, {"mesh", add_mesh(file, item.boxes, body)}});
  std::vector<double> places, rotations;
  Quaternion last = Quaternion::Identity();
  for (std::size_t i = 0; i < item.position.size(); ++i) {
    places.insert(places.end(), item.position[i].data(), item.position[i].data() + 3);
    Quaternion q = item.orientation[i].normalized();
    if (q.dot(last) < 0) q.coeffs() *= -1;
    rotations.insert(rotations.end(), q.coeffs().data(), q.coeffs().data() + 4);
    last = q;
  }
  file.animate(node, "translation", times, places, 3);
  file.animate(node, "rotation", times, rotations, 4);
  for (const RecordedWheel& wheel : item.wheels) add_wheel(file, node, wheel, times, rubber);
}

}  // namespace

std::vector<Vector3> triangles(const RecordedShape& shape) {
  const Vector3 middle = middle_of(shape.points);
  return shape.kind == "hull" ? hull(shape.points, middle) : prism(shape.points, middle);
}

RecordedShape shape_of(const RecordedWheel& wheel) {
  constexpr int kSides = 24;
  RecordedShape shape{wheel.name, "prism", {}};
  for (const double side : {-0.5, 0.5})
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2 * std::numbers::pi * i / kSides;
      shape.points.emplace_back(wheel.radius * std::cos(angle), side * wheel.width,
                                wheel.radius * std::sin(angle));
    }
  return shape;
}

std::string gltf(const RecordedRun& run) {
  const Vector3 colors[] = {{0.35, 0.6, 0.8}, {0.85, 0.6, 0.4},  {0.4, 0.7, 0.6},
                            {0.8, 0.6, 0.75}, {0.85, 0.75, 0.4}, {0.6, 0.6, 0.65}};
  Document file;
  // z upwards becomes y upwards.
  file.add("nodes", {{"name", run.title.empty() ? "run" : run.title},
                     {"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}});
  const std::size_t wall = add_material(file, "room", {0.7, 0.75, 0.8}, 0.25);
  const std::size_t rubber = add_material(file, "wheel", {0.08, 0.08, 0.09}, 1);
  for (const RecordedShape& shape : run.room)
    file.add_child(0, {{"name", shape.name}, {"mesh", add_mesh(file, {shape}, wall)}});
  const std::size_t times = file.accessor(run.time, 1);
  for (std::size_t i = 0; i < run.items.size(); ++i)
    add_item(file, run.items[i], times,
             add_material(file, "item", colors[i % std::size(colors)], 1), rubber);
  return file.text();
}

}  // namespace gurney::playback
