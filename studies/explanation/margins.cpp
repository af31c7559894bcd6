#include "studies/explanation/margins.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/units.h"
#include "equipment/catalogue/support.h"

namespace gurney::explanation {
namespace {

constexpr double kTilts = 0.1 * kRadiansPerDegree;

/// Where the item leans to, item axes, from the front anticlockwise [rad].
double direction_of(const Sample& sample) {
  const Vector3 down = sample.orientation.conjugate() * -Vector3::UnitZ();
  return std::atan2(down.y(), down.x());
}

/// Most horizontal force of a caster that carries N.
double grip_of(const Caster& caster, double normal) {
  const double most = caster.tread.static_friction * normal;
  if (caster.brake_torque > 0) return std::min(most, caster.brake_torque / caster.wheel_radius);
  const double torque = caster.tread.rolling_friction_length * normal + caster.axle.coulomb;
  return std::min(most, torque / caster.wheel_radius);
}

}  // namespace

double critical_tilt(const EquipmentModel& item, const Sample& sample) {
  if (!(sample.tilt >= kTilts)) return std::numeric_limits<double>::quiet_NaN();
  EquipmentModel now = item;
  for (std::size_t i = 0; i < now.casters.size(); ++i)
    now.casters[i].heading = sample.wheels[i].swivel_angle;
  const Vector3 center = whole_item(now).center_of_mass;
  const double reach =
      equipment::reach_towards(equipment::supports_of(now, equipment::Swivels::kAsPlaced),
                               center.head<2>(), direction_of(sample));
  return std::atan2(std::max(reach, 0.0), center.z());
}

TiltMargin tilt_margin(const EquipmentModel& item, const std::vector<Sample>& history,
                       double until) {
  TiltMargin margin;
  double largest = 0;
  for (const Sample& sample : history) {
    if (sample.time > until) break;
    const double critical = critical_tilt(item, sample);
    if (std::isnan(critical)) continue;
    const double ratio =
        critical > 0 ? sample.tilt / critical : std::numeric_limits<double>::infinity();
    if (ratio > 1 && margin.time_passed < 0) margin.time_passed = sample.time;
    if (ratio <= largest) continue;
    largest = ratio;
    margin.tilt = sample.tilt;
    margin.critical = critical;
    margin.time = sample.time;
    margin.direction = direction_of(sample);
  }
  return margin;
}

Grip grip_of(const study::RunFacts& facts, std::size_t item, const Sample& sample) {
  const Scene& scene = facts.scene;
  const EquipmentModel& model = scene.items.at(item).model;
  const Vector3 floor = facts.floor.acceleration_at(sample.time);
  const double mass = whole_item(model).mass;
  Grip result{mass * floor.head<2>().norm(), 0};
  for (std::size_t i = 0; i < model.casters.size(); ++i)
    result.grip += grip_of(model.casters[i], sample.wheels[i].normal_force);
  if (model.casters.empty())
    result.grip = contact_constants(scene, model.material, scene.floor_material).friction * mass *
                  std::max(scene.gravity + floor.z(), 0.0);
  return result;
}

GripMargin grip_margin(const study::RunFacts& facts, std::size_t item,
                       const std::vector<Sample>& history, double until) {
  GripMargin margin;
  for (const Caster& caster : facts.scene.items.at(item).model.casters)
    (caster.brake_torque > 0 ? margin.braked : margin.rolls) = true;
  double smallest = std::numeric_limits<double>::infinity();
  for (const Sample& sample : history) {
    if (sample.time > until) break;
    const Grip now = grip_of(facts, item, sample);
    margin.peak_demand = std::max(margin.peak_demand, now.demand);
    if (now.demand > now.grip && margin.time_exceeded < 0) margin.time_exceeded = sample.time;
    if (now.grip - now.demand >= smallest) continue;
    smallest = now.grip - now.demand;
    margin.demand = now.demand;
    margin.grip = now.grip;
    margin.time = sample.time;
  }
  return margin;
}

}  // namespace gurney::explanation
