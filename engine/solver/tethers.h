#pragma once

#include <vector>

#include "engine/caster/caster_dynamics.h"
#include "engine/response/energy_account.h"
#include "engine/scene/scene.h"
#include "engine/solver/cord_law.h"
#include "engine/solver/loads.h"
#include "engine/solver/state.h"

namespace gurney {

/// The tethers of one item that end in the room; those between items are joints (JointLaw). Each pulls with
/// cord_force() along the line to its anchor, so that a cord never pushes and takes up its load without a jump. A
/// tether breaks when T reaches its strength, an event at which a step ends (Stepper), and carries nothing any
/// more. Until then it also pulls with its slack pull H along slack_direction(): what hangs or lies on the floor
/// between the two has a horizontal tension, taut or not.
class Tethers {
 public:
  Tethers(const Scene& scene, std::size_t item, const Vector3& chassis_center);

  bool empty() const { return tethers_.empty(); }
  /// Index in Scene::tethers of each.
  const std::vector<std::size_t>& indices() const { return indices_; }

  /// Appends the rows of those that are whole, at the chassis velocity V at the end of a stage of
  /// length tau whose predicted end is `pose`.
  void evaluate(double tau, const State& start, const Pose& pose, const Vector6& velocity,
                std::vector<Loads::Row>& rows) const;

  /// Adds the power (W) of damping and of slack pulls to `power`, and returns the sum of k s'^2.
  double finish(double tau, const State& start, const Pose& pose, const Vector6& velocity,
                EnergyAccount& power) const;

  /// Load of those that are whole beyond their strength, over their stiffness: the largest; -1 without
  /// one that may break [m].
  double past_strength(const State& state) const;
  /// Breaks those loaded with their strength; returns the energy lost [J].
  double break_overstressed(State& state) const;

  double stored_energy(const State& state) const;
  /// T of the i-th while it is whole [N].
  double tension(std::size_t i, const State& state) const;

 private:
  struct Pull {
    Vector6 row;  // towards the anchor
    CordForce force;
    double rate = 0;
  };
  Pull pull(const Tether& tether, double tau, const State& start, const Pose& pose,
            const Vector6& velocity) const;
  Loads::Row slack_pull(const Tether& tether, const Pose& pose) const;
  double stretch(const Tether& tether, const State& state) const;
  double past_strength(std::size_t i, const State& state) const;

  std::vector<Tether> tethers_;  // points relative to the chassis' centre
  std::vector<std::size_t> indices_;
};

}  // namespace gurney
