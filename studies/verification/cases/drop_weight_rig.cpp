#include "studies/verification/cases/drop_weight_rig.h"

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"

namespace gurney::verification::rig {

using namespace scenes;

Exact::Exact(const Rig& rig, const EquipmentModel& item) {
  const double radius = DropWeight().pulley_radius;
  const double inertia = total_mass(item) + wheel_inertia_mass(item);
  pulley = rig.pulley_inertia / (radius * radius);
  resistance = rig.resistance * total_mass(item) * kStandardGravity;
  a1 = (rig.weight * kStandardGravity - resistance - rig.trolley_string - rig.weight_string) /
       (inertia + rig.weight + pulley);
  a2 = (resistance + rig.trolley_string) / inertia;
  tension = rig.weight * (kStandardGravity - a1) - rig.weight_string - pulley * a1;
  landing = std::sqrt(2 * rig.drop / a1);
  velocity = a1 * landing;
  distance = rig.drop + velocity * velocity / (2 * a2);
  stop = landing + velocity / a2;
}

double Exact::displacement(double t) const {
  const double pull = std::min(t, landing), coast = std::min(t, stop) - pull;
  return a1 * pull * pull / 2 + velocity * coast - a2 * coast * coast / 2;
}

double Exact::speed(double t) const {
  const double pull = std::min(t, landing), coast = std::min(t, stop) - pull;
  return a1 * pull - a2 * coast;
}

EquipmentModel pulled_trolley(const Rig& rig, double normal_stiffness) {
  ItemOptions options;
  options.total_mass = rig.mass;
  stiffen(options.caster.tread);
  options.caster.tread.normal_stiffness = normal_stiffness;
  options.caster.tread.rolling_friction_length = rig.resistance * options.caster.wheel_radius;
  return trolley(options);
}

std::vector<Load> rigged(const Rig& rig) {
  std::vector<Load> loads;
  DropWeight weight;
  weight.point = {0, 0, kPullHeight};
  weight.mass = rig.weight;
  weight.drop_height = rig.drop;
  weight.pulley_inertia = rig.pulley_inertia;
  weight.potentiometer_tension = rig.weight_string;
  weight.cable_stiffness = kCableStiffness;
  loads.push_back(weight);
  if (rig.trolley_string > 0)
    loads.push_back(
        StringPotentiometer{{0, 0, kPullHeight}, -Vector3::UnitX(), rig.trolley_string});
  Blocks blocks;
  blocks.point = {0, 0, rig.block_height};
  blocks.release_time = kReleaseTime;
  loads.push_back(blocks);
  return loads;
}

}  // namespace gurney::verification::rig
