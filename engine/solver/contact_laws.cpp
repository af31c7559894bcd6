#include "engine/solver/contact_laws.h"

namespace gurney {
namespace {

ContactConstants tread_constants(const Tread& tread) {
  return {.kind = ContactConstants::Kind::kCompliant,
          .stiffness = tread.normal_stiffness,
          .damping = tread.normal_damping,
          .friction = tread.kinetic_friction};
}

}  // namespace

ContactLaws::ContactLaws(const Scene& scene) {
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const EquipmentModel& model = scene.items[i].model;
    Item& item = items_.emplace_back();
    item.others.emplace_back(contact_constants(scene, model.material, scene.floor_material));
    for (const RoomShape& shape : scene.room)
      item.others.emplace_back(contact_constants(scene, model.material, shape.material));
    for (std::size_t j = i + 1; j < scene.items.size(); ++j)
      item.chassis.emplace_back(
          contact_constants(scene, model.material, scene.items[j].model.material));
    for (const Caster& caster : model.casters)
      item.wheels.emplace_back(tread_constants(caster.tread));
  }
}

const ImpactLaw& ContactLaws::of(const BodyContact& contact) const {
  const BodyContact::Side& a = contact.side;
  const BodyContact::Side& b = contact.other_side;
  const Item& item = items_[a.item];
  if (a.caster >= 0) return item.wheels[static_cast<std::size_t>(a.caster)];
  if (!contact.between_items()) return item.others[static_cast<std::size_t>(contact.other)];
  if (b.caster >= 0) return items_[b.item].wheels[static_cast<std::size_t>(b.caster)];
  return item.chassis[b.item - a.item - 1];
}

}  // namespace gurney
