#include "studies/explanation/variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "engine/run/overlaps.h"

namespace gurney::explanation {
namespace {

constexpr double kFarther = 0.5;  // [m]

Vector3 on_floor(const PlacedItem& item, const Vector3& point) {
  const Eigen::AngleAxisd turned(item.initial.yaw, Vector3::UnitZ());
  Vector3 place = turned * point;
  place.head<2>() += item.initial.position.head<2>();
  return place;
}

/// Cords reach the item where it stands now.
void lengthen_tethers(Scene& scene, std::size_t item) {
  for (Tether& tether : scene.tethers)
    if (tether.item == item)
      tether.slack_length = std::max(
          tether.slack_length, (tether.anchor - on_floor(scene.items[item], tether.point)).norm());
}

/// What the item stands in; empty: nothing.
std::string obstacle(const Scene& scene, std::size_t item) {
  if (scene.items.size() == 1 && scene.room.empty()) return {};
  for (const Overlap& overlap : find_overlaps(scene)) {
    const bool other = overlap.other_item >= 0;
    if (overlap.item == item)
      return other ? scene.items[static_cast<std::size_t>(overlap.other_item)].name
                   : scene.room[static_cast<std::size_t>(overlap.shape)].name;
    if (other && static_cast<std::size_t>(overlap.other_item) == item)
      return scene.items[overlap.item].name;
  }
  return {};
}

/// The variants of one item.
class Variants {
 public:
  Variants(const study::RunFacts& facts, const Explanation& of)
      : scene_(facts.scene), of_(of), item_(scene_.items.at(of.subject)) {}

  void brakes() {
    const std::vector<Caster>& casters = item_.model.casters;
    const auto braked = [](const Caster& c) { return c.brake_torque > 0; };
    Variant& on = add("all brakes on", "Locking every wheel");
    for (Caster& caster : of(on).model.casters)
      if (!braked(caster)) caster.brake_torque = std::numeric_limits<double>::infinity();
    if (casters.empty())
      on.reason = "it has no casters";
    else if (std::ranges::all_of(casters, braked))
      on.reason = "all of its casters are braked already";
    Variant& off = add("all brakes off", "Releasing its brakes");
    for (Caster& caster : of(off).model.casters) caster.brake_torque = 0;
    if (casters.empty())
      off.reason = "it has no casters";
    else if (std::ranges::none_of(casters, braked))
      off.reason = "none of its casters is braked";
  }

  void headings() {
    for (const int angle : {90, 180, 270}) {
      Variant& turned = add(fmt::format("turned by {} deg", angle),
                            fmt::format("Turning it by {} degrees", angle));
      of(turned).initial.yaw += angle * kRadiansPerDegree;
      move(turned);
    }
  }

  void walls() {
    const bool hit = of_.hit.has_value();
    const std::string other = hit ? other_name() : "";
    const std::string farther_words = of_.units.text(kFarther, "m");
    Variant& farther = add(hit ? farther_words + " farther from " + other : "farther from walls",
                           "Standing " + farther_words + " farther from " + other);
    Variant& without = add(hit ? fmt::format("without {}", other) : "without walls",
                           fmt::format("Taking {} away", other));
    if (!hit) {
      farther.reason = without.reason =
          scene_.room.empty() ? "there is nothing in the room" : "it hit nothing hard";
      return;
    }
    const double side = of_.hit->item == of_.subject ? 1 : -1;
    Vector2 away = side * of_.hit->normal.head<2>();
    if (away.norm() < 0.1) away = -of_.direction;
    of(farther).initial.position.head<2>() += kFarther * away.normalized();
    move(farther);
    remove(without, other);
  }

  void center_of_mass() {
    for (const int percent : {10, 20}) {
      Variant& lower = add(fmt::format("centre of mass {} % lower", percent),
                           fmt::format("Lowering its centre of mass by {} %", percent));
      EquipmentModel& model = of(lower).model;
      const MassProperties whole = whole_item(model), rigid = chassis_with_payloads(model);
      const double down = 0.01 * percent * whole.center_of_mass.z() * whole.mass / rigid.mass;
      model.chassis_center_of_mass.z() -= down;
      for (Payload& payload : model.payloads) payload.center_of_mass.z() -= down;
      if (model.chassis_center_of_mass.z() <= 0)
        lower.reason = "the chassis would have its mass below the floor";
    }
  }

  void tethers() {
    const bool tethered =
        std::ranges::any_of(scene_.tethers, [&](const Tether& t) { return t.item == of_.subject; });
    Variant& without = add("without its cords", "Taking its cords away");
    std::erase_if(without.scene.tethers, [&](const Tether& t) { return t.item == of_.subject; });
    if (!tethered) without.reason = "nothing ties it to the room";
    Variant& straps = add("with two straps", "Holding it with two straps");
    if (of_.direction.isZero()) {
      straps.reason = "it did not move in any direction";
      return;
    }
    const Vector3 point = whole_item(item_.model).center_of_mass;
    for (const double side : {1.0, -1.0}) add_strap(straps.scene, point, side);
  }

  std::vector<Variant> all() && { return std::move(variants_); }

 private:
  Variant& add(const std::string& name, const std::string& clause) {
    variants_.reserve(16);  // references into it stay
    return variants_.emplace_back(Variant{name, clause, scene_, {}});
  }

  PlacedItem& of(Variant& variant) const { return variant.scene.items[of_.subject]; }

  void move(Variant& variant) const {
    lengthen_tethers(variant.scene, of_.subject);
    if (const std::string in = obstacle(variant.scene, of_.subject); !in.empty())
      variant.reason = "it would stand in " + in;
  }

  std::string other_name() const {
    return of_.hit->item == of_.subject ? of_.hit->other : of_.items.at(of_.hit->item).name;
  }

  void remove(Variant& variant, const std::string& other) const {
    const auto erased =
        std::erase_if(variant.scene.room, [&](const RoomShape& s) { return s.name == other; });
    if (erased == 0) variant.reason = other + " is an item, not a part of the room";
  }

  void add_strap(Scene& scene, const Vector3& point, double side) const {
    constexpr double kSlack = 0.02, kStiffness = 5e4, kDamping = 500;
    double reach = 0;
    for (const Box& box : item_.model.shape)
      reach = std::max(reach, (box.center.cwiseAbs() + box.size / 2).head<2>().norm());
    const Vector3 from = on_floor(item_, point);
    Vector3 anchor = from;
    anchor.head<2>() += side * (reach + 0.3) * of_.direction;
    Tether strap;
    strap.name = side > 0 ? "strap ahead" : "strap behind";
    strap.item = of_.subject;
    strap.point = point;
    strap.anchor = anchor;
    strap.slack_length = (anchor - from).norm() + kSlack;
    strap.stiffness = kStiffness;
    strap.damping = kDamping;
    scene.tethers.push_back(strap);
  }

  const Scene& scene_;
  const Explanation& of_;
  const PlacedItem& item_;
  std::vector<Variant> variants_;
};

}  // namespace

std::vector<Variant> variants_of(const study::RunFacts& facts, const Explanation& of) {
  Variants variants(facts, of);
  variants.brakes();
  variants.headings();
  variants.walls();
  variants.center_of_mass();
  variants.tethers();
  return std::move(variants).all();
}

}  // namespace gurney::explanation
