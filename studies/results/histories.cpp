#include "studies/results/histories.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "studies/results/names.h"

namespace gurney::study {
namespace {

/// Height of the surface on which an item, or the one whose part it is, stands [m].
double height_at_start(const Scene& scene, std::size_t item) {
  const std::optional<Support>& on = scene.items[root_of(scene, item)].on;
  return on ? on->height : 0;
}

}  // namespace

/// Between samples of the record the velocity is quadratic in time, so Simpson's rule
/// h / 6 (v_0 + 4 v_1/2 + v_1) is its integral but for rounding.
std::vector<Vector3> floor_displacement(const FloorMotion& floor,
                                        const std::vector<double>& times) {
  std::vector<Vector3> result;
  Vector3 displacement = Vector3::Zero();
  double now = 0;
  Eigen::Index next = 1;
  const auto move_to = [&](double time) {
    displacement += (time - now) / 6 *
                    (floor.velocity_at(now) + 4 * floor.velocity_at((now + time) / 2) +
                     floor.velocity_at(time));
    now = time;
  };
  for (const double time : times) {
    for (; next < floor.acceleration().cols(); ++next) {
      const double sample = floor.time_step() * static_cast<double>(next);
      if (sample >= time) break;
      move_to(sample);
    }
    if (time > now) move_to(time);
    result.push_back(displacement);
  }
  return result;
}

void add_floor_histories(Hdf5Writer& file, const FloorMotion& floor,
                         const std::vector<double>& times) {
  const auto add = [&](const char* name, const char* units, const char* meaning, const auto& at) {
    std::vector<double> values;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Vector3 value = at(i);
      values.insert(values.end(), value.data(), value.data() + value.size());
    }
    file.add({std::string("/histories/floor_") + name,
              units,
              meaning,
              {"/histories/time", "/histories/axis"}},
             values);
  };
  const std::vector<Vector3> displacement = floor_displacement(floor, times);
  add("displacement", "m", "displacement of the floor since the start of the record",
      [&](std::size_t i) { return displacement[i]; });
  add("velocity", "m/s", "velocity of the floor",
      [&](std::size_t i) { return floor.velocity_at(times[i]); });
  add("acceleration", "m/s2", "acceleration of the floor, without gravity",
      [&](std::size_t i) { return floor.acceleration_at(times[i]); });
}

namespace {

constexpr int kSides = 16;  ///< of what is round

struct Shape {
  std::string item, body, kind;
  /// Origin of its axes from the point whose displacement is stored, in item axes; of the room: 0.
  Vector3 pivot = Vector3::Zero();
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

std::string kind_of(const BodyShape& shape) {
  if (shape.is_box()) return "box";
  return std::holds_alternative<SolidCylinder>(shape.solid) ? "prism" : "hull";
}

std::vector<Vector3> points_of(const BodyShape& shape) {
  if (shape.is_box()) return box_points(shape.center, shape.size);
  if (const auto* cylinder = std::get_if<SolidCylinder>(&shape.solid))
    return ring_points(shape.center, cylinder->radius, 0.5 * cylinder->length * cylinder->axis,
                       cylinder->axis.unitOrthogonal());
  return outline_points(shape);
}

std::vector<Shape> shapes_of(const PlacedItem& item, const std::string& name,
                             const Vector3& tracked) {
  std::vector<Shape> shapes;
  for (const BodyShape& shape : item.model.shape)
    shapes.push_back(
        {name, "chassis", kind_of(shape), Vector3::Zero() - tracked, points_of(shape)});
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

void add_shapes(Hdf5Writer& file, const Scene& scene, const Response& response) {
  std::vector<Shape> shapes;
  const std::vector<std::string> names = item_names(scene);
  for (std::size_t i = 0; i < names.size(); ++i)
    for (Shape& shape : shapes_of(scene.items[i], names[i], response.items[i].tracked))
      shapes.push_back(std::move(shape));
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
            "origin of the body's axes, in item axes, from the item's origin, of a part from its "
            "centre of "
            "mass",
            {"/shapes/shape", "/shapes/axis"}},
           pivots);
  file.add(
      {"/shapes/point", "m", "the points, in the body's axes", {"/shapes/vertex", "/shapes/axis"}},
      points);
}

namespace {

using Items = std::vector<ItemResponse>;

/// Calls `take` for every sample of every item, in the order in which the file keeps them.
template <class Take>
void each_sample(const Items& items, Take take) {
  for (std::size_t s = 0; s < items.front().history.size(); ++s)
    for (std::size_t i = 0; i < items.size(); ++i) take(i, items[i].history.at(s));
}

/// Names of the casters or points of all items; with several items as "item/caster".
std::vector<std::string> part_names(const Scene& scene,
                                    std::vector<std::string> (*names_of)(const EquipmentModel&)) {
  const std::vector<std::string> items = item_names(scene);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < items.size(); ++i)
    for (const std::string& name : names_of(scene.items[i].model))
      names.push_back(items.size() == 1 ? name : items[i] + "/" + name);
  return names;
}

template <class Vector>
void append(std::vector<double>& values, const Vector& vector) {
  values.insert(values.end(), vector.data(), vector.data() + vector.size());
}

void add_body_histories(Hdf5Writer& file, const Items& items) {
  const std::vector<std::string> scales{"/histories/time", "/histories/item"};
  const auto add_vector = [&](const char* name, const char* units, const char* meaning,
                              Vector3 Sample::*member) {
    std::vector<double> values;
    each_sample(items, [&](std::size_t, const Sample& s) { append(values, s.*member); });
    file.add({std::string("/histories/") + name,
              units,
              meaning,
              {"/histories/time", "/histories/item", "/histories/axis"}},
             values);
  };
  add_vector("displacement", "m",
             "displacement of the item's origin, of a part its centre of mass, relative to the "
             "floor since the start",
             &Sample::displacement);
  add_vector("velocity", "m/s",
             "velocity of the item's origin, of a part its centre of mass, relative to the floor",
             &Sample::velocity);
  add_vector(
      "acceleration", "m/s2",
      "acceleration of the item's origin, of a part its centre of mass, relative to the floor",
      &Sample::acceleration);
  std::vector<Sample> samples;
  std::vector<EnergyAccount> energy;
  std::vector<double> orientation;
  each_sample(items, [&](std::size_t, const Sample& s) {
    samples.push_back(s);
    energy.push_back(s.energy);
    const Quaternion& q = s.orientation;
    orientation.insert(orientation.end(), {q.w(), q.x(), q.y(), q.z()});
  });
  add_columns(file, "/histories/", sample_columns(), scales, samples);
  file.add({"/histories/orientation",
            "1",
            "unit quaternion that turns item axes to floor axes",
            {"/histories/time", "/histories/item", "/histories/component"}},
           orientation);
  add_columns(file, "/histories/", energy_columns(), scales, energy);
}

void add_wheel_histories(Hdf5Writer& file, const Scene& scene, const Items& items) {
  const std::vector<std::string> scales{"/histories/time", "/histories/wheel"};
  std::vector<WheelSample> samples;
  std::vector<std::uint8_t> modes;
  each_sample(items, [&](std::size_t item, const Sample& sample) {
    for (std::size_t i = 0; i < scene.items[item].model.casters.size(); ++i) {
      samples.push_back(sample.wheels[i]);
      modes.push_back(static_cast<std::uint8_t>(sample.wheels[i].mode));
    }
  });
  add_columns(file, "/histories/", wheel_sample_columns(), scales, samples);
  file.add({"/histories/mode", "1", "what the wheel does, coded as flag_meanings says", scales},
           modes);
  std::vector<std::uint8_t> codes;
  std::string meanings;
  for (const WheelMode mode : {WheelMode::kSticks, WheelMode::kRolls, WheelMode::kSkids,
                               WheelMode::kBraked, WheelMode::kLifted}) {
    codes.push_back(static_cast<std::uint8_t>(mode));
    meanings += (meanings.empty() ? "" : " ") + std::string(name_of(mode));
  }
  file.set_attribute("/histories/mode", "flag_values", codes);
  file.set_attribute("/histories/mode", "flag_meanings", meanings);
}

void add_point_histories(Hdf5Writer& file, const Items& items) {
  const std::vector<std::string> scales{"/histories/time", "/histories/point", "/histories/axis"};
  const auto add = [&](const char* name, const char* units, const char* meaning, auto member) {
    std::vector<double> values;
    each_sample(items, [&](std::size_t, const Sample& sample) {
      for (const PointSample& point : sample.points) append(values, point.*member);
    });
    file.add({std::string("/histories/point_") + name, units, meaning, scales}, values);
  };
  add("displacement", "m", "displacement of the point relative to the floor since the start",
      &PointSample::displacement);
  add("velocity", "m/s", "velocity of the point relative to the floor", &PointSample::velocity);
  add("absolute_acceleration", "m/s2", "absolute acceleration of the point, without gravity",
      &PointSample::absolute_acceleration);
}

}  // namespace

void add_histories(Hdf5Writer& file, const RunFacts& facts, const Response& response) {
  const Scene& scene = facts.scene;
  std::vector<double> time;
  for (const Sample& sample : response.items.front().history) time.push_back(sample.time);
  file.add_group("/histories");
  file.add_scale({"/histories/run", "1", "index of the run", {}}, std::vector<std::int64_t>{0});
  file.add_scale({"/histories/time", "s", "time, one run after the other", {}}, time);
  const auto add_names = [&](const char* name, const char* meaning,
                             const std::vector<std::string>& names) {
    file.add_scale({std::string("/histories/") + name, "1", meaning, {}}, names);
  };
  add_names("item", "name of the item", item_names(scene));
  add_names("wheel", "name of the caster; of several items: item/caster",
            part_names(scene, caster_names));
  add_names("point", "name of the marked point; of several items: item/point",
            part_names(scene, point_names));
  add_names("axis", "floor axis", {"x", "y", "z"});
  add_names("component", "component of a quaternion", {"w", "x", "y", "z"});
  std::vector<double> starts;
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const auto& position = scene.items[i].initial.position;
    Vector3 start(position.x(), position.y(), height_at_start(scene, i));
    const ItemResponse& item = response.items[i];
    if (!item.history.empty()) {
      const Sample& first = item.history.front();
      start += first.to_origin + first.orientation * item.tracked;
    }
    append(starts, start);
  }
  file.add(
      {"/histories/start",
       "m",
       "where the item's origin, of a part its centre of mass, is at the start, less what the item "
       "settles on what it stands on",
       {"/histories/item", "/histories/axis"}},
      starts);
  file.add({"/histories/offset", "1", "first sample of the run", {"/histories/run"}},
           std::vector<std::int64_t>{0});
  file.add({"/histories/count", "1", "number of samples of the run", {"/histories/run"}},
           std::vector<std::int64_t>{static_cast<std::int64_t>(time.size())});
  add_floor_histories(file, facts.floor, time);
  add_body_histories(file, response.items);
  add_wheel_histories(file, scene, response.items);
  add_point_histories(file, response.items);
}

}  // namespace gurney::study
