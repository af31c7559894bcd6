#include "engine/scene/validate_room.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "engine/scene/problems.h"

namespace gurney {
namespace {

void check_shape(const RoomShape& shape, Problems& problems) {
  const std::string owner = "room shape '" + shape.name + "': ";
  problems.check(!shape.name.empty() && shape.name != "floor",
                 owner + "the name must not be empty or 'floor'");
  problems.check(shape.position.allFinite(), owner + "position: must be finite");
  const double norm = shape.rotation.norm();
  problems.check(std::abs(norm - 1) < 1e-9, owner + "norm of rotation", norm, "1");
  if (const auto* box = std::get_if<RoomBox>(&shape.shape)) {
    for (int k = 0; k < 3; ++k) problems.positive(owner + "size", box->size[k]);
  } else if (const auto* column = std::get_if<RoomColumn>(&shape.shape)) {
    problems.positive(owner + "radius", column->radius);
    problems.positive(owner + "height", column->height);
  } else {
    problems.check(spans_a_volume(std::get<RoomHull>(shape.shape).points),
                   owner + "points: 4 or more that span a volume are needed");
  }
}

void check_zone(const Zone& zone, Problems& problems) {
  const std::string owner = "zone '" + zone.name + "': ";
  problems.check(!zone.name.empty(), owner + "the name must not be empty");
  problems.check(zone.center.allFinite() && std::isfinite(zone.angle),
                 owner + "center and angle: must be finite");
  problems.positive(owner + "length", zone.length);
  problems.positive(owner + "width", zone.width);
}

void check_tether(const Scene& scene, const Tether& tether, Problems& problems) {
  const std::string owner = "tether '" + tether.name + "': ";
  problems.check(!tether.name.empty(), owner + "the name must not be empty");
  problems.positive(owner + "slack_length", tether.slack_length);
  problems.positive(owner + "stiffness", tether.stiffness);
  problems.not_negative(owner + "damping", tether.damping);
  problems.not_negative(owner + "slack_pull", tether.slack_pull);
  problems.check(tether.strength > 0, owner + "strength", tether.strength, "> 0");
  problems.check(tether.point.allFinite() && tether.anchor.allFinite(),
                 owner + "point and anchor: must be finite");
  if (tether.item >= scene.items.size())
    return problems.check(false, owner + "there is no such item");
  if (tether.anchor_item &&
      (*tether.anchor_item >= scene.items.size() || *tether.anchor_item == tether.item))
    return problems.check(false, owner + "it must end at another item");
  const double distance = placed_length(scene, tether);
  problems.check(distance <= tether.slack_length,
                 fmt::format("{}slack_length = {:g}: must be at least {:g}, the distance to its "
                             "anchor at the start",
                             owner, tether.slack_length, distance));
}

template <typename T>
void check_names(const std::vector<T>& all, const char* kind, Problems& problems) {
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      problems.check(all[i].name != all[j].name,
                     fmt::format("{} '{}': the name is taken twice", kind, all[i].name));
}

void check_items(const Scene& scene, Problems& problems) {
  std::set<std::string> names{"floor"};
  for (const RoomShape& shape : scene.room) names.insert(shape.name);
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const std::string& name = scene.items[i].name;
    problems.check(scene.items.size() == 1 || (!name.empty() && names.insert(name).second),
                   "item '" + name + "': the name must be given and not be taken");
    std::size_t tethers = 0;
    for (const Tether& tether : scene.tethers) tethers += tether.item == i;
    problems.check(tethers <= EquipmentModel::kMaxTethers, "item '" + name + "': number of tethers",
                   static_cast<double>(tethers), "32 at most");
  }
}

}  // namespace

void validate_room(const Scene& scene) {
  Problems problems;
  for (const MaterialPair& pair : scene.pairs) {
    const ContactConstants& c = pair.constants;
    const std::string owner = fmt::format("pair of '{}' and '{}': ", pair.item, pair.other);
    problems.positive(owner + "stiffness", c.stiffness);
    problems.not_negative(owner + "damping", c.damping);
    problems.not_negative(owner + "friction", c.friction);
    problems.not_negative(owner + "rolling resistance", c.rolling_resistance);
    problems.check(c.restitution >= 0.01 && c.restitution <= 1, owner + "restitution",
                   c.restitution, "in 0.01..1");
  }
  for (const RoomShape& shape : scene.room) check_shape(shape, problems);
  for (const Zone& zone : scene.zones) check_zone(zone, problems);
  for (const Tether& tether : scene.tethers) check_tether(scene, tether, problems);
  check_names(scene.room, "room shape", problems);
  check_names(scene.zones, "zone", problems);
  check_names(scene.tethers, "tether", problems);
  check_items(scene, problems);
  problems.finish();
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const std::string& material = scene.items[i].model.material;
    contact_constants(scene, material, scene.floor_material);
    for (const RoomShape& shape : scene.room) contact_constants(scene, material, shape.material);
    for (std::size_t j = 0; j < i; ++j)
      contact_constants(scene, material, scene.items[j].model.material);
  }
}

}  // namespace gurney
