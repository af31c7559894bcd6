#include "engine/bullet/contact_search.h"

#include <algorithm>
#include <cmath>

namespace gurney {
namespace {

/// A pass is made for wheels nearer than this: the distance that Bullet finds of smooth bodies is off
/// by far less than 1 mm.
constexpr double kWheelRange = WheelSearch::kMargin + 1e-3;  // [m]

constexpr double kMaxParts = 100;  // of a step, each with a search of its own

/// How fast any point of the item moves at most, with a share of its wheels' spin.
double speed_of(const Mechanism& mechanism, const State& state, double spin = 1) {
  double swing = 0, joints = 0;
  for (std::size_t i = 0; i < mechanism.casters.size(); ++i) {
    const auto& rates = state.velocity.joints[i];
    swing = std::max(swing, mechanism.casters[i].swing());
    joints = std::max(joints, std::abs(rates[0]) + spin * std::abs(rates[1]));
  }
  return state.velocity.chassis.head<3>().norm() +
         state.velocity.chassis.tail<3>().norm() * mechanism.reach + joints * swing;
}

/// How fast any part of the item sweeps through space at most: a wheel's spin does not count.
double sweep_of(const Mechanism& mechanism, const State& state) {
  return speed_of(mechanism, state, 0);
}

/// How fast two things get nearer to each other at most.
double approach_speed(const Assembly& assembly, const SceneState& state) {
  double fastest = 0, second = 0;
  for (std::size_t i = 0; i < state.items.size(); ++i) {
    const double speed = speed_of(assembly.items[i], state.items[i]);
    second = std::max(second, std::min(speed, fastest));
    fastest = std::max(fastest, speed);
  }
  return fastest + second;
}

}  // namespace

ContactSearch::ContactSearch(const Scene& scene, const Assembly& assembly, bool skip_clear_passes)
    : assembly_(assembly),
      travels_(assembly, skip_clear_passes),
      chassis_points_(scene, assembly),
      wheel_clearance_(scene, assembly),
      wheels_(scene, assembly),
      skip_clear_passes_(skip_clear_passes),
      alone_(scene.room.empty() && scene.items.size() == 1) {
  for (std::size_t i = 0; i < scene.items.size(); ++i)
    floor_points_.emplace_back(scene.items[i].model, assembly.items[i], i);
}

double ContactSearch::next(const SceneState& state, double time, double until) const {
  if (alone_) return until;
  double fastest = 0;
  for (std::size_t i = 0; i < state.items.size(); ++i)
    fastest = std::max(fastest, sweep_of(assembly_.items[i], state.items[i]));
  const double remaining = until - time;
  const double parts = std::min(std::ceil(remaining * fastest / WheelSearch::kMargin), kMaxParts);
  return parts < 2 ? until : time + remaining / parts;
}

const std::vector<BodyContact>& ContactSearch::find(const SceneState& state, double step,
                                                    const Riders* riders) {
  contacts_.clear();
  travels_.observe(state);
  const double margin = WheelSearch::kMargin + 2 * step * approach_speed(assembly_, state);
  for (std::size_t i = 0; i < floor_points_.size(); ++i)
    floor_points_[i].collect(state.items[i], travels_.of(i), margin, contacts_);
  chassis_points_.collect(state, travels_, step, margin, contacts_, riders);
  if (skip_clear_passes_ && !wheel_clearance_.any_near(state, travels_, kWheelRange))
    return contacts_;
  wheels_.collect(state, step, contacts_);
  ++collision_passes_;
  return contacts_;
}

}  // namespace gurney
