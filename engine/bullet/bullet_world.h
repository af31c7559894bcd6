#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/scene/scene.h"
#include "engine/solver/assembly.h"

namespace gurney {

/// Bullet's world with our solve in it.
///
/// A subclass of btMultiBodyDynamicsWorld holds each item as a btMultiBody with its shapes, and the
/// shapes of the room. Each pass is one stepSimulation: Bullet finds the contacts between
/// them (those with the flat floor and of the chassis with the room are analytic: FloorPoints,
/// ChassisPoints), and where it would solve constraints and integrate, it calls us.
///
/// Bullet's pass is skipped while no wheel is near anything but the floor (WheelClearance), and the
/// analytic search for pairs that bounds on their motion keep apart (Clearance); results are the
/// same bits either way.
class BulletWorld {
 public:
  BulletWorld(const Scene& scene, const Assembly& assembly, bool skip_clear_passes);
  ~BulletWorld();

  /// Advances the state to a time with the contacts found at its start.
  /// @returns false when the run cannot go on
  using Solve = std::function<bool(double until, const std::vector<BodyContact>& contacts)>;

  /// Advances `state` from `from` to `until` with `solve`: in one pass, or in several where parts move so fast
  /// that they would travel past the margin between two.
  /// @returns false when `solve` did
  bool step(double from, double until, SceneState& state, const Solve& solve);

  long collision_passes() const;

 private:
  class World;
  std::unique_ptr<World> world_;
};

}  // namespace gurney
