#include "studies/calibration/pulling/pull_theory.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"

namespace gurney::calibration {
namespace {

bool along_x(const Vector3& direction) { return std::abs(direction.normalized().x()) > 1 - 1e-9; }

void add_item(const Scene& scene, PullTheory& theory) {
  const EquipmentModel& item = scene.items[0].model;
  theory.mass = whole_item(item).mass;
  theory.normal_force = theory.mass * scene.gravity;
  const double each = theory.normal_force / static_cast<double>(item.casters.size());
  for (const Caster& c : item.casters) {
    theory.added_mass += c.wheel_axial_inertia / (c.wheel_radius * c.wheel_radius);
    theory.resistance += c.tread.rolling_friction_length / c.wheel_radius * each;
  }
}

void add_drop_weight(const Scene& scene, const DropWeight& weight, const Blocks& blocks,
                     PullTheory& theory) {
  const double pulley = weight.pulley_inertia / (weight.pulley_radius * weight.pulley_radius);
  theory.drop_mass = weight.mass;
  theory.start = blocks.release_time;
  theory.held_force = weight.mass * scene.gravity - weight.potentiometer_tension;
  theory.acceleration = (theory.held_force - theory.resistance - theory.string_tension) /
                        (theory.mass + theory.added_mass + weight.mass + pulley);
  theory.force = theory.held_force - (weight.mass + pulley) * theory.acceleration;
  theory.release = theory.start + std::sqrt(2 * weight.drop_height / theory.acceleration);
  theory.pull = {{theory.start, theory.force, theory.acceleration},
                 {theory.release, theory.force, theory.acceleration}};
}

void add_force(const PointForce& force, PullTheory& theory) {
  theory.start = force.time.front();
  theory.release = force.time.back();
  double impulse = 0;
  for (std::size_t i = 0; i < force.time.size(); ++i) {
    theory.pull.push_back({force.time[i], force.force[i],
                           (force.force[i] - theory.resistance - theory.string_tension) /
                               (theory.mass + theory.added_mass)});
    if (i > 0)
      impulse += (force.time[i] - force.time[i - 1]) * (force.force[i] + force.force[i - 1]) / 2;
  }
  theory.force = impulse / (theory.release - theory.start);
  theory.acceleration = (theory.force - theory.resistance - theory.string_tension) /
                        (theory.mass + theory.added_mass);
}

/// `time` after a knot, towards the next one: the acceleration is linear, the speed its integral.
PullTheory::Knot moved_on(const PullTheory::Knot& from, const PullTheory::Knot& to, double time) {
  const double share = time / (to.time - from.time);
  const double jerk = (to.acceleration - from.acceleration) / (to.time - from.time);
  return {from.time + time, from.force + share * (to.force - from.force),
          from.acceleration + jerk * time,
          from.velocity + from.acceleration * time + jerk * time * time / 2,
          from.displacement + from.velocity * time + from.acceleration * time * time / 2 +
              jerk * time * time * time / 6};
}

void integrate(std::vector<PullTheory::Knot>& pull) {
  for (std::size_t i = 1; i < pull.size(); ++i)
    pull[i] = moved_on(pull[i - 1], pull[i], pull[i].time - pull[i - 1].time);
}

}  // namespace

PullTheory::Knot PullTheory::pulled_at(double time) const {
  const double within = std::clamp(time, start, release);
  const auto after = std::ranges::upper_bound(pull, within, {}, &Knot::time) - pull.begin();
  const auto next = std::clamp<std::size_t>(static_cast<std::size_t>(after), 1, pull.size() - 1);
  return moved_on(pull[next - 1], pull[next], within - pull[next - 1].time);
}

double PullTheory::displacement_at(double time) const {
  const double coast = std::clamp(time, release, stop) - release;
  return pulled_at(time).displacement + release_velocity * coast - deceleration * coast * coast / 2;
}

double PullTheory::velocity_at(double time) const {
  return pulled_at(time).velocity - deceleration * (std::clamp(time, release, stop) - release);
}

double PullTheory::acceleration_at(double time) const {
  if (time < start || time >= stop) return 0;
  return time < release ? pulled_at(time).acceleration : -deceleration;
}

double PullTheory::force_at(double time) const {
  if (time < start) return held_force;
  return time < release ? pulled_at(time).force : 0;
}

PullTheory theory_of(const Scene& scene) {
  const PlacedItem& item = scene.items.front();
  const auto weights = loads_of<DropWeight>(item.loads);
  const auto blocks = loads_of<Blocks>(item.loads);
  const auto forces = loads_of<PointForce>(item.loads);
  const bool dropped =
      weights.size() == 1 && forces.empty() && !blocks.empty() && along_x(weights[0].direction);
  const bool forced = weights.empty() && forces.size() == 1 && forces[0].time.size() >= 2 &&
                      std::isinf(forces[0].speed_limit) && along_x(forces[0].direction);
  require(scene.items.size() == 1 && !item.model.casters.empty() && (dropped || forced),
          "is no pulling test: one item on casters must be pulled along x by one drop weight that "
          "blocks hold, or by one force without a speed limit");
  PullTheory theory;
  add_item(scene, theory);
  for (const StringPotentiometer& string : loads_of<StringPotentiometer>(item.loads)) {
    require(along_x(string.direction), "string potentiometers must pull along x");
    theory.string_tension -= string.tension * string.direction.normalized().x();
  }
  if (dropped)
    add_drop_weight(scene, weights[0], blocks[0], theory);
  else
    add_force(forces[0], theory);
  theory.deceleration =
      (theory.resistance + theory.string_tension) / (theory.mass + theory.added_mass);
  require(theory.acceleration > 0 && theory.deceleration > 0,
          "is no pulling test: the pull must move the item, which must come to rest after it");
  integrate(theory.pull);
  theory.release_velocity = theory.pull.back().velocity;
  theory.release_displacement = theory.pull.back().displacement;
  const double coast = theory.release_velocity / theory.deceleration;
  theory.stop = theory.release + coast;
  theory.rest_displacement = theory.release_displacement + theory.release_velocity * coast / 2;
  return theory;
}

}  // namespace gurney::calibration
