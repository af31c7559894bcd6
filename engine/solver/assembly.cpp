#include "engine/solver/assembly.h"

#include "engine/base/append_all.h"
#include "engine/base/units.h"

namespace gurney {

Assembly::Assembly(const Scene& scene)
    : laws(scene), gravity(gravity_on_slope(scene.gravity, scene.slope, scene.cross_slope)) {
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    items.emplace_back(scene, i);
    roots.push_back(root_of(scene, i));
  }
  std::vector<double> carried;
  for (const Mechanism& item : items) carried.push_back(item.total_mass);
  for (std::size_t i = items.size(); i-- > 0;)
    if (const auto joint = joint_of(scene, i)) carried[scene.joints[*joint].base] += carried[i];
  for (const Joint& joint : scene.joints)
    joints.emplace_back(joint, items[joint.base], items[joint.part], carried[joint.part]);
  for (std::size_t i = 0; i < scene.tethers.size(); ++i)
    if (const Tether& tether = scene.tethers[i]; tether.anchor_item)
      joints.emplace_back(tether, i, items[*tether.anchor_item], items[tether.item]);
}

JointLaw::Rows Assembly::rows(std::size_t j, const SceneState& state) const {
  const Joint& joint = joints[j].joint();
  return joints[j].rows(state.items[joint.base].pose(), state.items[joint.part].pose(),
                        state.joints[j].coordinate);
}

double Assembly::joint_motion(std::size_t j, const SceneState& state) const {
  const Joint& joint = joints[j].joint();
  if (joint.kind == Joint::Kind::kHinge || joint.kind == Joint::Kind::kSlider)
    return state.joints[j].coordinate;
  return state.items[joint.base].rotation.angularDistance(state.items[joint.part].rotation);
}

double Assembly::joint_rate(std::size_t j, const SceneState& state) const {
  const JointLaw::Rows of_joint = rows(j, state);
  const Joint& joint = joints[j].joint();
  if (!of_joint.along) return 0;
  return of_joint.rows[*of_joint.along].rate(state.items[joint.part].velocity.chassis,
                                             state.items[joint.base].velocity.chassis);
}

double Assembly::mobility(const JointLaw::Rows& of_joint, std::size_t j,
                          const SceneState& state) const {
  const Joint& joint = joints[j].joint();
  const JointLaw::Row& row = of_joint.rows[*of_joint.along];
  return items[joint.part].mobility(row.part, state.items[joint.part]) +
         items[joint.base].mobility(row.base, state.items[joint.base]);
}

double Assembly::joint_energy(std::size_t item, const SceneState& state) const {
  double energy = 0;
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (joints[j].joint().part == item)
      energy += joints[j].stored_energy(rows(j, state), state.joints[j]);
  return energy;
}

std::vector<double> Assembly::breakpoints() const {
  std::vector<double> times;
  for (const Mechanism& item : items) {
    const std::vector<double> of_item = item.loads.breakpoints();
    append_all(times, of_item);
  }
  return times;
}

Vector3 Assembly::point(const BodyContact& contact, const SceneState& state) const {
  const std::size_t item = contact.side.item;
  return items[item].point(contact.side, state.items[item]);
}

double Assembly::gap(const BodyContact& contact, const SceneState& state) const {
  const Vector3 here = state.items[contact.side.item].position + point(contact, state);
  const double along = contact.normal.dot(here) - contact.offset;
  if (!contact.between_items()) return along;
  const BodyContact::Side& b = contact.other_side;
  const State& other = state.items[b.item];
  return along - contact.normal.dot(other.position + items[b.item].point(b, other));
}

Vector3 Assembly::velocity(const BodyContact& contact, const SceneState& state) const {
  const BodyContact::Side &a = contact.side, &b = contact.other_side;
  const Vector3 velocity = items[a.item].velocity(a, state.items[a.item]);
  if (!contact.between_items()) return velocity;
  return velocity - items[b.item].velocity(b, state.items[b.item]);
}

std::optional<Assembly::Roller> Assembly::roller(const BodyContact& contact) const {
  std::optional<Roller> found;
  const auto take = [&](const BodyContact::Side& side) {
    if (side.round < 0) return;
    const Mechanism& item = items[side.item];
    const RoundSurface& round = item.surfaces[static_cast<std::size_t>(side.round)];
    if (found && found->resistance.radius <= round.radius) return;
    found = {{.radius = round.radius, .weight = item.total_mass * kStandardGravity},
             side.item,
             round.axis};
  };
  take(contact.side);
  if (contact.between_items()) take(contact.other_side);
  if (!found) return {};
  found->resistance.length = laws.of(contact).rolling_resistance();
  return found->resistance.length > 0 ? found : std::nullopt;
}

double Assembly::contact_energy(std::size_t item, const SceneState& state) const {
  double energy = 0;
  for (const BodyContactState& memory : state.contacts) {
    if (memory.contact.side.item != item) continue;
    energy += laws.of(memory.contact).stored_energy(memory.compression, memory.deflection.norm());
    if (const auto of = roller(memory.contact)) energy += of->resistance.stored_energy(memory.lead);
  }
  return energy;
}

}  // namespace gurney
