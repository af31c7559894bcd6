#include "equipment/catalogue/at_rest.h"

#include <cmath>

#include "engine/base/error.h"
#include "engine/run/rest.h"

namespace gurney::equipment {
namespace {

/// Axes of a body in those of the chassis.
struct Place {
  Matrix3 turn;
  Vector3 origin;

  Vector3 operator()(const Vector3& point) const { return origin + turn * point; }
};

BodyShape placed(const BodyShape& shape, const Place& place) {
  constexpr double kLevel = 1e-4;  // [rad], 0.1 mm over 1 m
  const Vector3 center = place(shape.center);
  if (Eigen::AngleAxisd(place.turn).angle() < kLevel) return shape.moved(center - shape.center);
  if (const auto* sphere = std::get_if<SolidSphere>(&shape.solid))
    return sphere_shape(center, sphere->radius);
  if (const auto* cylinder = std::get_if<SolidCylinder>(&shape.solid))
    return cylinder_shape(center,
                          {place.turn * cylinder->axis, cylinder->radius, cylinder->length});
  std::vector<Vector3> points = outline_points(shape);
  for (Vector3& point : points) point = place(point);
  return hull_shape(points);
}

void put(EquipmentModel& body, const Place& place) {
  const auto turned = [&place](const Matrix3& inertia) -> Matrix3 {
    return place.turn * inertia * place.turn.transpose();
  };
  body.chassis_center_of_mass = place(body.chassis_center_of_mass);
  body.chassis_inertia = turned(body.chassis_inertia);
  for (BodyShape& shape : body.shape) shape = placed(shape, place);
  for (Payload& payload : body.payloads) {
    payload.center_of_mass = place(payload.center_of_mass);
    payload.inertia = turned(payload.inertia);
  }
  for (MarkedPoint& point : body.marked_points) point.position = place(point.position);
}

/// The item alone on a floor; all of one material, which settling does not ask for.
Scene scene_of(const LoadedItem& item) {
  Scene scene;
  const std::string& material = item.model.material;
  for (const char* other : {"", material.c_str()})
    scene.pairs.push_back({material, other, item.pairs.front().constants});
  const auto add = [&](const EquipmentModel& model) -> PlacedItem& {
    PlacedItem& added = scene.items.emplace_back();
    added.name = model.name;
    added.model = model;
    added.model.material = material;
    return added;
  };
  add(item.model);
  for (const LoadedPart& part : item.parts) {
    scene.joints.push_back(part.joint);
    scene.joints.back().part = scene.items.size();
    add(part.model);
  }
  for (const LoadedContent& content : item.contents) {
    PlacedItem& added = add(content.model);
    added.on = Support{Support::Kind::kItem, content.on, content.position.z()};
    added.initial.position = content.position;
    added.initial.yaw = content.yaw;
  }
  return scene;
}

}  // namespace

LoadedItem at_rest(LoadedItem item) {
  if (item.parts.empty()) return item;
  std::vector<RestingBody> bodies;
  try {
    bodies = gurney::at_rest(scene_of(item));
  } catch (const Error& error) {
    item.warnings.push_back(std::string(error.what()) + "; its parts are shown at q = 0");
    return item;
  }
  const auto place_of = [&bodies](std::size_t body) -> Place {
    const Quaternion back = bodies[0].orientation.conjugate();
    return {(back * bodies[body].orientation).toRotationMatrix(),
            back * (bodies[body].origin - bodies[0].origin)};
  };
  std::size_t body = 0;
  for (LoadedPart& part : item.parts) {
    put(part.model, place_of(++body));
    part.coordinate = bodies[body].coordinate;
  }
  for (LoadedContent& content : item.contents) {
    const Place place = place_of(++body);
    content.position = place.origin;
    content.yaw = std::atan2(place.turn(1, 0), place.turn(0, 0));
  }
  return item;
}

}  // namespace gurney::equipment
