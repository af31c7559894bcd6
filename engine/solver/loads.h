#pragma once

#include <vector>

#include "engine/caster/caster_dynamics.h"
#include "engine/response/energy_account.h"
#include "engine/scene/scene.h"
#include "engine/solver/force_table.h"
#include "engine/solver/loads_state.h"

namespace gurney {

/// All loads and springs on one chassis, each a force along one generalised direction of the
/// chassis: with `row` the direction, u = row . V and the force T(u) row.
///
/// Drop weights are solved with the step: the weight's own equation is eliminated, so that T(u) of
/// an elastic cable holds its inertia exactly, and a slack cable carries nothing.
class Loads {
 public:
  Loads(const PlacedItem& item, const Vector3& chassis_center, double gravity);

  /// Cables are taut under the weight when blocks hold the item.
  LoadsState initial_state() const;

  /// Times at which a load starts, stops or changes slope.
  std::vector<double> breakpoints() const;

  /// One implicit stage.
  struct Stage {
    double tau = 0;
    double from = 0, to = 0;  ///< the step this stage belongs to [s]
    bool first = true;        ///< first or second stage of the step
    const LoadsState* start = nullptr;
    double floor_acceleration_up = 0;  ///< acts on drop weights as more gravity [m/s2]
  };

  struct Row {
    Vector6 direction;
    double force = 0;
    double slope = 0;  ///< -dT/du >= 0
  };

  /// Rows and forces at chassis velocity V.
  void evaluate(const Stage& stage, const Pose& pose, const Vector6& velocity,
                std::vector<Row>& rows) const;

  /// Adds powers (W) to `power`, writes the new state, and returns the sum of k x'^2 of its
  /// springs.
  /// @param rows  begin with those that evaluate() gave
  double finish(const Stage& stage, const Pose& pose, const Vector6& velocity,
                const std::vector<Row>& rows, EnergyAccount& power, LoadsState& end) const;

  /// Takes over the deflections of the fixture's springs from a state of other loads.
  void adopt_springs(const Loads& other, const LoadsState& other_state, LoadsState& state) const;

  double stored_energy(const LoadsState& state) const;
  double weight_energy(const LoadsState& state) const;
  /// Sum of the point forces (signed magnitudes) [N].
  double pull_force(double time, const Pose& pose, const Vector6& velocity) const;
  double cable_tension(const LoadsState& state) const;

  /// How far the first unlanded weight is below its floor (> 0: it has hit); -1 when none falls.
  double penetration(const LoadsState& state) const;
  /// Ends the fall of every weight that has reached its floor: it stops and its cable goes slack;
  /// returns the energy lost [J].
  double land(LoadsState& state) const;
  /// Blocks whose time has come let go of what they hold; returns the energy lost [J].
  double release(double time, LoadsState& state) const;

  bool holds_at_start() const { return !blocks_.empty(); }
  bool empty() const {
    return forces_.empty() && strings_.empty() && weights_.empty() && blocks_.empty() &&
           springs_.empty();
  }

 private:
  struct Force {
    Vector3 point, direction;
    ForceTable table;
    double speed_limit;
  };
  struct Weight {
    Vector3 point, direction;
    double weight_mass, inertia, force, drop_height, gravity, stiffness, damping, tension_on_weight;
  };
  struct Block {
    Vector3 point;
    double stiffness, damping, release_time;
  };
  struct Spring {
    int dof;
    double stiffness, damping;
  };
  struct Cable {
    double tension, slope, weight_speed, stretch_rate;
  };
  Cable cable(const Weight& weight, const LoadsState::Weight& start, double u,
              const Stage& stage) const;

  std::vector<Force> forces_;
  std::vector<StringPotentiometer> strings_;
  std::vector<Weight> weights_;
  std::vector<Block> blocks_;
  std::vector<Spring> springs_;
};

}  // namespace gurney
