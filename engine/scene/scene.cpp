#include "engine/scene/scene.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "engine/base/error.h"
#include "engine/scene/problems.h"
#include "engine/scene/validate_room.h"

namespace gurney {
namespace {

void check(const PointForce& force, Problems& problems) {
  problems.finite("force.point", force.point);
  problems.direction("force.direction", force.direction);
  problems.check(force.time.size() == force.force.size() && force.time.size() >= 2, "force.time",
                 static_cast<double>(force.time.size()), "as many times as forces, 2 or more");
  for (std::size_t i = 0; i < force.time.size(); ++i) {
    problems.check(std::isfinite(force.time[i]) && (i == 0 || force.time[i] > force.time[i - 1]),
                   "force.time", force.time[i], "increasing and finite");
    if (i < force.force.size())
      problems.check(std::isfinite(force.force[i]), "force.force", force.force[i], "finite");
  }
  problems.check(force.speed_limit > 0, "force.speed_limit", force.speed_limit, "> 0");
  for (const double value : force.force)
    problems.check(value >= 0 || std::isinf(force.speed_limit), "force.force", value,
                   ">= 0 with a speed limit");
}

void check(const DropWeight& weight, Problems& problems) {
  problems.finite("drop_weight.point", weight.point);
  problems.direction("drop_weight.direction", weight.direction);
  problems.positive("drop_weight.mass", weight.mass);
  problems.positive("drop_weight.drop_height", weight.drop_height);
  problems.not_negative("drop_weight.pulley_inertia", weight.pulley_inertia);
  problems.positive("drop_weight.pulley_radius", weight.pulley_radius);
  problems.not_negative("drop_weight.potentiometer_tension", weight.potentiometer_tension);
  problems.positive("drop_weight.cable_stiffness", weight.cable_stiffness);
  problems.not_negative("drop_weight.cable_damping", weight.cable_damping);
}

void check(const StringPotentiometer& string, Problems& problems) {
  problems.finite("string_potentiometer.point", string.point);
  problems.direction("string_potentiometer.direction", string.direction);
  problems.not_negative("string_potentiometer.tension", string.tension);
}

void check(const Blocks& blocks, Problems& problems) {
  problems.finite("blocks.point", blocks.point);
  problems.positive("blocks.stiffness", blocks.stiffness);
  problems.not_negative("blocks.damping", blocks.damping);
  problems.positive("blocks.release_time", blocks.release_time);
}

void check(const Fixture& fixture, Problems& problems) {
  for (int dof = 0; dof < 6; ++dof) {
    const Guide& guide = fixture.guides[dof];
    problems.check(std::isfinite(guide.velocity), "guide.velocity", guide.velocity, "finite");
    problems.not_negative("guide.stiffness", guide.stiffness);
    problems.not_negative("guide.damping", guide.damping);
    problems.check(guide.kind != Guide::Kind::kSpring || dof < 3, "guide.stiffness",
                   guide.stiffness, "on x, y or z only");
  }
}

void check(const Support& on, const Scene& scene, std::size_t item, Problems& problems) {
  const bool of_item = on.kind == Support::Kind::kItem;
  problems.check(on.index < (of_item ? item : scene.room.size()), "on.index",
                 static_cast<double>(on.index),
                 of_item ? "of an item before it" : "of a shape of the room");
  problems.positive("on.height", on.height);
  problems.check(scene.items[item].model.casters.empty(), "casters",
                 static_cast<double>(scene.items[item].model.casters.size()),
                 "0 on an item or a shape of the room");
}

void check(const Joint& joint, const Scene& scene, Problems& problems) {
  using Kind = Joint::Kind;
  const bool one_way = joint.kind == Kind::kHinge || joint.kind == Kind::kSlider;
  problems.check(joint.base < joint.part && joint.part < scene.items.size(), "joint.part",
                 static_cast<double>(joint.part), "an item after its base");
  problems.finite("joint.point", joint.point);
  problems.check(std::abs(joint.axis.norm() - 1) < 1e-9, "joint.axis", joint.axis.norm(),
                 "of length 1");
  problems.not_negative("joint.stiffness", joint.stiffness);
  problems.not_negative("joint.damping", joint.damping);
  problems.check(std::isfinite(joint.rest), "joint.rest", joint.rest, "finite");
  problems.not_negative("joint.friction", joint.friction);
  problems.check(joint.lower <= 0, "joint.lower", joint.lower, "<= 0");
  problems.check(joint.upper >= 0, "joint.upper", joint.upper, ">= 0");
  problems.positive("joint.stop_stiffness", joint.stop_stiffness);
  problems.check(joint.restitution >= 0.01 && joint.restitution <= 1, "joint.restitution",
                 joint.restitution, "in 0.01..1");
  problems.check(joint.latch >= 0, "joint.latch", joint.latch, ">= 0");
  problems.check(one_way || (joint.friction == 0 && joint.latch == 0 && joint.rest == 0 &&
                             std::isinf(joint.lower) && std::isinf(joint.upper)),
                 "joint.kind", static_cast<double>(joint.kind),
                 "a hinge or a slider where it has friction, a latch, stops or a rest");
  if (!(joint.base < joint.part && joint.part < scene.items.size())) return;
  const PlacedItem &base = scene.items[joint.base], &part = scene.items[joint.part];
  problems.check(base.initial.position == part.initial.position &&
                     base.initial.yaw == part.initial.yaw && !part.on,
                 "joint.part", static_cast<double>(joint.part),
                 "placed as its base is, and stand on nothing");
  problems.check(joint_of(scene, joint.part) == static_cast<std::size_t>(&joint - &scene.joints[0]),
                 "joint.part", static_cast<double>(joint.part), "the part of one joint only");
}

std::string name_of(const std::string& material) {
  return material.empty() ? "(none)" : "'" + material + "'";
}

}  // namespace

ContactConstants contact_constants(const Scene& scene, const std::string& item,
                                   const std::string& other) {
  for (const MaterialPair& pair : scene.pairs)
    if ((pair.item == item && pair.other == other) || (pair.item == other && pair.other == item))
      return pair.constants;
  require(item.empty() && other.empty(),
          fmt::format("no contact constants for the materials {} of an item and {}", name_of(item),
                      name_of(other)));
  return {};
}

const std::string& material_below(const Scene& scene, std::size_t item) {
  const std::optional<Support>& on = scene.items[item].on;
  if (!on) return scene.floor_material;
  return on->kind == Support::Kind::kItem ? scene.items[on->index].model.material
                                          : scene.room[on->index].material;
}

std::optional<std::size_t> joint_of(const Scene& scene, std::size_t item) {
  for (std::size_t j = 0; j < scene.joints.size(); ++j)
    if (scene.joints[j].part == item) return j;
  return {};
}

std::size_t root_of(const Scene& scene, std::size_t item) {
  while (const auto joint = joint_of(scene, item)) item = scene.joints[*joint].base;
  return item;
}

namespace {

/// The item that another hangs or stands on; none: the floor or a shape of the room.
std::optional<std::size_t> item_below(const Scene& scene, std::size_t item) {
  if (const auto joint = joint_of(scene, item)) return scene.joints[*joint].base;
  const std::optional<Support>& on = scene.items[item].on;
  if (on && on->kind == Support::Kind::kItem) return on->index;
  return {};
}

}  // namespace

std::size_t carrier_of(const Scene& scene, std::size_t item) {
  while (const auto below = item_below(scene, item)) item = *below;
  return item;
}

bool stands_on(const Scene& scene, std::size_t item, std::size_t below) {
  const std::size_t root = root_of(scene, below);
  if (root_of(scene, item) == root) return false;
  for (auto next = item_below(scene, item); next; next = item_below(scene, *next))
    if (root_of(scene, *next) == root) return true;
  return false;
}

Vector3 placed_point(const Scene& scene, std::size_t item, const Vector3& point) {
  const InitialMotion& initial = scene.items[item].initial;
  Vector3 origin(initial.position.x(), initial.position.y(), 0);
  if (const auto& on = scene.items[root_of(scene, item)].on) origin.z() = on->height;
  return origin + Eigen::AngleAxisd(initial.yaw, Vector3::UnitZ()) * point;
}

Vector3 placed_anchor(const Scene& scene, const Tether& tether) {
  return tether.anchor_item ? placed_point(scene, *tether.anchor_item, tether.anchor)
                            : tether.anchor;
}

double placed_length(const Scene& scene, const Tether& tether) {
  return (placed_anchor(scene, tether) - placed_point(scene, tether.item, tether.point)).norm();
}

void move_item(Scene& scene, std::size_t item, const Vector3& position, double yaw) {
  const InitialMotion from = scene.items[item].initial;
  const Quaternion turn(Eigen::AngleAxisd(yaw - from.yaw, Vector3::UnitZ()));
  std::vector<bool> moves(scene.items.size());
  for (std::size_t i = item; i < scene.items.size(); ++i) {
    const auto below = item_below(scene, i);
    moves[i] = i == item || (below && *below >= item && moves[*below]);
    if (!moves[i]) continue;
    InitialMotion& initial = scene.items[i].initial;
    initial.position = position + turn * (initial.position - from.position);
    initial.yaw += yaw - from.yaw;
  }
}

Scene scene_of(EquipmentModel model) {
  Scene scene;
  scene.items.push_back({{}, std::move(model)});
  return scene;
}

void validate(const Scene& scene) {
  require(!scene.items.empty(), "a scene needs an item");
  for (const PlacedItem& item : scene.items) validate(item.model);
  Problems problems;
  problems.not_negative("gravity", scene.gravity);
  problems.check(std::abs(scene.slope) <= 1, "slope", scene.slope, "in -1..1");
  problems.check(std::abs(scene.cross_slope) <= 1, "cross_slope", scene.cross_slope, "in -1..1");
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const PlacedItem& item = scene.items[i];
    if (item.on) check(*item.on, scene, i, problems);
    const InitialMotion& initial = item.initial;
    problems.finite("initial.position", initial.position);
    problems.finite("initial.velocity", initial.velocity);
    problems.check(std::isfinite(initial.yaw), "initial.yaw", initial.yaw, "finite");
    problems.check(std::isfinite(initial.yaw_rate), "initial.yaw_rate", initial.yaw_rate, "finite");
    for (const Load& load : item.loads)
      std::visit([&](const auto& of_kind) { check(of_kind, problems); }, load);
    check(item.fixture, problems);
  }
  for (const Joint& joint : scene.joints) check(joint, scene, problems);
  problems.finish();
  validate_room(scene);
}

}  // namespace gurney
