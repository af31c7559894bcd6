#include "engine/record/recorder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/solver/equilibrium.h"
#include "engine/solver/quadrature.h"

namespace gurney {
namespace {

/// Horizontal direction of a chassis: its x axis; of a cylinder on its side the axis of the cylinder, which
/// stays as it rolls.
Vector3 heading_of(const std::optional<Vector3>& roller) {
  constexpr double kUpright = 0.5;  // cosine
  return roller && std::abs(roller->z()) < kUpright ? *roller : Vector3::UnitX();
}

double tilt_of(const Matrix3& rotation) { return std::acos(std::clamp(rotation(2, 2), -1.0, 1.0)); }

/// Axis of a chassis that is one cylinder, zero of one that is a sphere, which has no heading either: a body
/// that rolls does not overturn.
std::optional<Vector3> axis_of_roller(const EquipmentModel& model) {
  if (model.shape.size() != 1) return {};
  if (const auto* cylinder = std::get_if<SolidCylinder>(&model.shape[0].solid))
    return cylinder->axis;
  if (std::holds_alternative<SolidSphere>(model.shape[0].solid)) return Vector3::Zero();
  return {};
}

double horizontal(const Vector3& v) { return v.head<2>().norm(); }

/// A body of an item with parts may be at rest while the others are not, and the springs below one that
/// stands on another are those of that: its energies are then those of rounding. What would raise the
/// whole item by a micrometre is nothing [J].
double least_energy(const Assembly& assembly, std::size_t item, bool on_another) {
  constexpr double kRise = 1e-6;  // [m]
  double mass = 0;
  std::size_t bodies = 0;
  for (std::size_t i = 0; i < assembly.items.size(); ++i) {
    if (!assembly.joined(i, item)) continue;
    mass += assembly.items[i].total_mass;
    ++bodies;
  }
  return bodies > 1 || on_another ? mass * assembly.gravity.norm() * kRise : 0;
}

WheelMode mode_of(const CasterDynamics& caster, const TreadLaw::Result& tread, bool axle_slips) {
  if (tread.force[2] <= 0) return WheelMode::kLifted;
  if (tread.end.sliding) return WheelMode::kSkids;
  if (caster.braked() && !axle_slips) return WheelMode::kBraked;
  return tread.end.rolling ? WheelMode::kRolls : WheelMode::kSticks;
}

}  // namespace

Recorder::Recorder(const Scene& scene, const Assembly& assembly, std::size_t item,
                   const SceneState& at_start)
    : assembly_(assembly),
      item_(item),
      mechanism_(assembly.items[item]),
      energies_(mechanism_),
      origin_(assembly.is_part(item) ? Vector3::Zero().eval()
                                     : Vector3(-mechanism_.chassis.center_of_mass)) {
  const Mechanism& mechanism = mechanism_;
  const State& start = at_start.items[item];
  const EquipmentModel& model = scene.items[item].model;
  const Matrix3 rotation = start.rotation.toRotationMatrix();
  for (const auto& point : model.marked_points) {
    points_.push_back(point.position - mechanism_.chassis.center_of_mass);
    point_starts_.push_back(start.position + rotation * points_.back());
  }
  origin_start_ = start.position + rotation * origin_;
  const std::optional<Support>& on = scene.items[item].on;
  on_item_ = on && on->kind == Support::Kind::kItem;
  for (std::size_t i = 0; i < scene.items.size(); ++i)
    if (stands_on(scene, i, item)) carries_.push_back(static_cast<int>(i));
  const bool on_part = on_item_ && assembly.is_part(on->index);
  if (assembly.is_part(item) || on_part) {
    const auto settled = [&](std::size_t i) -> Vector3 {
      const Vector3& center = assembly.items[i].chassis.center_of_mass;
      const State placed = placed_above(assembly, scene, i), &now = at_start.items[i];
      return now.position - now.rotation * center - placed.position + placed.rotation * center;
    };
    if (!on_part) tracked_ = mechanism.chassis.center_of_mass;
    settled_ =
        settled(item) - settled(assembly.roots[on_part ? on->index : item]) + rotation * tracked_;
    current_.to_origin = settled_ - rotation * tracked_;
  }
  roller_ = axis_of_roller(model);
  heading_ = heading_of(roller_);
  yaw_start_ = yaw_ = yaw_of(rotation);
  for (const auto& caster : model.casters) trails_.push_back(caster.trail);
  gaps_.resize(mechanism.casters.size());
  demands_.wheels.resize(mechanism.casters.size());
  demands_.points.resize(points_.size());
  current_.points.resize(points_.size());
  gravitational_start_ = energies_.at(start).gravitational;
  stored_start_ = complete(at_start, {}).stored();
  sampled_ = checked_ =
      EnergyBalance(stored_start_, least_energy(assembly, item, scene.items[item].on.has_value()));
  current_.velocity =
      start.velocity.chassis.head<3>() + start.velocity.chassis.tail<3>().cross(rotation * origin_);
  current_.tilt = demands_.peak_tilt = lean_of(rotation);
  current_.orientation = start.rotation;
  current_.cable_tension = mechanism.loads.cable_tension(start.loads);
  current_.pull_force =
      mechanism.loads.pull_force(start.time, start.pose(), start.velocity.chassis);
  demands_.peak_velocity = horizontal(current_.velocity);
  for (std::size_t i = 0; i < mechanism.casters.size(); ++i) {
    const double gap =
        mechanism.casters[i].contact(start.pose(), start.casters[i].swivel_angle).height;
    gaps_[i] = {gap, 0, gap >= 0, start.time};
    WheelSample& wheel = current_.wheels[i];
    wheel.swivel_angle = start.casters[i].swivel_angle;
    wheel.swivel_rate = start.velocity.joints[i][0];
    wheel.wheel_rate = start.velocity.joints[i][1];
    wheel.normal_force = mechanism.casters[i].tread().static_force(-gap);
    wheel.mode = wheel.normal_force > 0 ? WheelMode::kSticks : WheelMode::kLifted;
    demands_.wheels[i].peak_normal_force = wheel.normal_force;
    demands_.peak_normal_force = std::max(demands_.peak_normal_force, wheel.normal_force);
  }
}

double Recorder::yaw_of(const Matrix3& rotation) const {
  if (heading_.isZero()) return 0;
  const Vector3 heading = rotation * heading_;
  return std::atan2(heading.y(), heading.x());
}

double Recorder::lean_of(const Matrix3& rotation) const {
  if (!roller_) return tilt_of(rotation);
  const double from = std::acos(std::clamp(roller_->z(), -1.0, 1.0));
  return std::abs(std::acos(std::clamp((rotation * *roller_).z(), -1.0, 1.0)) - from);
}

void Recorder::observe(const Stepper::Step& step, const ImpactLog::Kinds& impacts) {
  const State& to = step.to->items[item_];
  const Matrix3 rotation = to.rotation.toRotationMatrix();
  const Vector3 v = to.velocity.chassis.head<3>(), w = to.velocity.chassis.tail<3>();
  const Vector6& a = step.end->items[item_].acceleration.chassis;
  const Vector3 r = rotation * origin_;
  const Vector3 before = current_.displacement;
  current_.time = to.time;
  current_.displacement = to.position + r - origin_start_;
  current_.to_origin = settled_ - rotation * tracked_;
  current_.velocity = v + w.cross(r);
  current_.acceleration = a.head<3>() + a.tail<3>().cross(r) + w.cross(w.cross(r));
  // An item on its side has no heading.
  if (!has_overturned_) yaw_ += std::remainder(yaw_of(rotation) - yaw_, 2 * std::numbers::pi);
  current_.yaw = yaw_ - yaw_start_;
  current_.tilt = lean_of(rotation);
  current_.orientation = to.rotation;

  Demands& d = demands_;
  d.path_length += horizontal(current_.displacement - before);
  const double distance = horizontal(current_.displacement);
  if (distance > d.peak_displacement) {
    d.peak_displacement = distance;
    d.time_of_peak_displacement = to.time;
  }
  d.peak_displacement_x = std::max(d.peak_displacement_x, std::abs(current_.displacement.x()));
  d.peak_displacement_y = std::max(d.peak_displacement_y, std::abs(current_.displacement.y()));
  d.peak_velocity = std::max(d.peak_velocity, horizontal(current_.velocity));
  d.peak_yaw = std::max(d.peak_yaw, std::abs(current_.yaw));
  if (current_.tilt > d.peak_tilt) {
    d.peak_tilt = current_.tilt;
    d.time_of_peak_tilt = to.time;
  }
  speed_ = body_speed_ = v.norm() + w.norm() * mechanism_.reach;
  observe_wheels(step);
  observe_points(step, rotation, impacts);
}

void Recorder::overturned() {
  has_overturned_ = true;
  const Vector3 up = current_.orientation * Vector3::UnitZ();
  demands_.direction_of_overturning = std::atan2(up.y(), up.x());
  for (std::size_t i = 0; i < gaps_.size(); ++i)
    if (gaps_[i].lifted) demands_.wheels[i].liftoff_before_overturning = gaps_[i].since;
}

void Recorder::observe_wheels(const Stepper::Step& step) {
  const State& to = step.to->items[item_];
  for (std::size_t i = 0; i < mechanism_.casters.size(); ++i) {
    const CasterDynamics& caster = mechanism_.casters[i];
    const TreadLaw::Result& tread = step.end->items[item_].treads[i];
    const Eigen::Vector2d& rates = to.velocity.joints[i];
    WheelSample& wheel = current_.wheels[i];
    wheel.swivel_angle = to.casters[i].swivel_angle;
    wheel.swivel_rate = rates[0];
    wheel.wheel_rate = rates[1];
    wheel.normal_force = tread.force[2];
    const Vector2 tangential = tread.force.head<2>();
    const Vector2& heading = step.end->items[item_].heading[i];
    wheel.longitudinal_force = heading.dot(tangential);
    wheel.lateral_force = heading.x() * tangential.y() - heading.y() * tangential.x();
    wheel.scrub_torque = caster.tread().spin_radius() * tread.force[3];
    wheel.rolling_resistance_force = tread.force[4] / caster.wheel_radius();
    wheel.mode = mode_of(caster, tread, to.casters[i].axle_slips);
    // A wheel in the air may spin on a free axle for ever; that is no motion of the item.
    const double spin = wheel.mode == WheelMode::kLifted ? 0 : std::abs(rates[1]);
    speed_ = std::max({speed_, std::abs(rates[0]) * (trails_[i] + caster.wheel_radius()),
                       spin * caster.wheel_radius()});

    WheelDemands& d = demands_.wheels[i];
    d.peak_normal_force = std::max(d.peak_normal_force, wheel.normal_force);
    d.peak_tangential_force = std::max(d.peak_tangential_force, tangential.norm());
    d.skid_distance +=
        step.duration * ((1 - kSdirkGamma) * step.first->items[item_].treads[i].slip_speed +
                         kSdirkGamma * tread.slip_speed);
    demands_.peak_normal_force = std::max(demands_.peak_normal_force, wheel.normal_force);
  }
  observe_lift(step);
  current_.cable_tension = mechanism_.loads.cable_tension(to.loads);
  current_.pull_force = mechanism_.loads.pull_force(to.time, to.pose(), to.velocity.chassis);
}

void Recorder::observe_lift(const Stepper::Step& step) {
  const double h = step.duration;
  bool near = false;
  std::array<Gap, kMaxCasters> now;
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    const TreadLaw::Result& tread = step.end->items[item_].treads[i];
    now[i] = {-tread.compression, -tread.compression_rate, tread.compression <= 0,
              gaps_[i].lifted ? gaps_[i].since : step.time + h};
    near |= gaps_[i].height + h * std::max(gaps_[i].rate, 0.0) > 0 ||
            now[i].height + h * std::max(-now[i].rate, 0.0) > 0;
  }
  // The gap between the ends of the step is the cubic through its heights and rates there.
  constexpr int kParts = 16;
  for (int part = 0; near && part < kParts; ++part) {
    const double s = (part + 0.5) / kParts, r = 1 - s;
    int lifted = 0;
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      const Gap& a = gaps_[i];
      const Gap& b = now[i];
      const double height = a.height * r * r * (1 + 2 * s) + b.height * s * s * (1 + 2 * r) +
                            h * s * r * (a.rate * r - b.rate * s);
      if (height < 0) continue;
      ++lifted;
      demands_.wheels[i].lifted_time += h / kParts;
    }
    if (lifted > 0) demands_.lifted_time += h / kParts;
    demands_.most_wheels_lifted = std::max(demands_.most_wheels_lifted, lifted);
  }
  for (std::size_t i = 0; i < gaps_.size(); ++i) {
    if (now[i].lifted && !gaps_[i].lifted) ++demands_.wheels[i].liftoffs;
    gaps_[i] = now[i];
  }
}

void Recorder::observe_points(const Stepper::Step& step, const Matrix3& rotation,
                              const ImpactLog::Kinds& impacts) {
  const State& to = step.to->items[item_];
  const Vector3 v = to.velocity.chassis.head<3>(), w = to.velocity.chassis.tail<3>();
  const Vector6& a = step.end->items[item_].acceleration.chassis;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vector3 r = rotation * points_[i];
    PointSample& point = current_.points[i];
    point.displacement = to.position + r - point_starts_[i];
    point.velocity = v + w.cross(r);
    point.absolute_acceleration = a.head<3>() + a.tail<3>().cross(r) + w.cross(w.cross(r)) +
                                  step.floor.acceleration_at(to.position + r);
    PointDemands& d = demands_.points[i];
    d.peak_displacement = std::max(d.peak_displacement, horizontal(point.displacement));
    const double acceleration = point.absolute_acceleration.norm();
    if (impacts.restitution) {
      d.numerical_acceleration = std::fmax(d.numerical_acceleration, acceleration);
      continue;
    }
    d.peak_absolute_acceleration = std::max(d.peak_absolute_acceleration, acceleration);
    if (impacts.compliant) d.impact_acceleration = std::fmax(d.impact_acceleration, acceleration);
  }
}

EnergyAccount Recorder::complete(const SceneState& scene, const EnergyAccount& account) const {
  const State& state = scene.items[item_];
  EnergyAccount energy = account;
  const MechanicalEnergy of_item = energies_.at(state);
  energy.kinetic = of_item.kinetic;
  energy.gravitational = of_item.gravitational - gravitational_start_;
  energy.elastic = of_item.elastic + assembly_.contact_energy(item_, scene) +
                   assembly_.joint_energy(item_, scene);
  energy.weight_energy = mechanism_.loads.weight_energy(state.loads);
  return energy;
}

void Recorder::sample(const SceneState& state, const EnergyAccount& account, bool keep) {
  current_.energy = complete(state, account);
  sampled_.observe(current_.energy);
  if (keep) history_.push_back(current_);
}

void Recorder::check(const SceneState& state, const EnergyAccount& account) {
  checked_.observe(complete(state, account));
}

void Recorder::finish(const SceneState& state, const EnergyAccount& account, double overturned_at,
                      Response& response) {
  ItemResponse item;
  Demands& d = item.demands = demands_;
  (on_item_ ? d.time_of_toppling : d.time_of_overturning) = overturned_at;
  d.residual_displacement = horizontal(current_.displacement);
  d.residual_displacement_x = current_.displacement.x();
  d.residual_displacement_y = current_.displacement.y();
  d.residual_yaw = current_.yaw;
  for (const Impact& impact : response.impacts) {
    const bool is_first = impact.item == item_;
    if (!is_first && impact.other_item != static_cast<int>(item_)) continue;
    const int other = is_first ? impact.other_item : static_cast<int>(impact.item);
    if (std::ranges::find(carries_, other) != carries_.end()) continue;
    ++d.impacts;
    d.largest_approach_speed = std::max(d.largest_approach_speed, impact.approach_speed);
    d.largest_impulse = std::max(d.largest_impulse, impact.impulse);
    d.peak_impact_force = std::fmax(d.peak_impact_force, impact.peak_force);
  }
  item.energy = complete(state, account);
  item.stored_energy_at_start = stored_start_;
  item.tracked = tracked_;
  item.history = std::move(history_);
  Quality& q = response.quality;
  q.energy_closure = std::max(q.energy_closure, sampled_.closure());
  const double numerical = sampled_.numerical_loss();
  if (std::abs(numerical) > std::abs(q.numerical_loss)) q.numerical_loss = numerical;
  response.items.push_back(std::move(item));
}

}  // namespace gurney
