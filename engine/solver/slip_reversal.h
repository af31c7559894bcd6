#pragma once

#include <vector>

#include "engine/solver/assembly.h"
#include "engine/solver/island.h"

namespace gurney {

/// Friction that slides on through zero slip velocity changes its sign within the step, but an
/// implicit stage gives it the sign at the stage's end for all of it: the velocity is wrong by up
/// to 2 mu g h from there on. A contact whose spring is soft spreads the change over sqrt(M / k_t)
/// and needs no event; of one stiffer than the step, the step ends at the reversal.
class SlipReversals {
 public:
  SlipReversals(const Assembly& assembly, double time_step);

  /// How the velocities of an item change: those of its last step, if known.
  struct Course {
    Velocity acceleration;
    Vector3 floor_acceleration = Vector3::Zero();  ///< that they hold for
    bool known = false;
  };

  /// Collects the stiff contacts of the island that slide at `state`.
  void collect(const Island& island, const SceneState& state, const std::vector<Course>& courses);
  bool none() const { return slips_.empty(); }

  /// Time until the first of them has its least slip velocity, under the floor's mean acceleration
  /// `floor`; infinite if none slows down [s].
  double first(const Vector3& floor) const;

 private:
  struct Slip {
    Vector3 velocity, acceleration;  ///< of the slip [m/s], [m/s2]
    Matrix3 of_floor;                ///< slip directions in floor axes
    Vector3 floor_acceleration;
  };
  void collect_treads(std::size_t item, const State& state, const Course& course);
  void collect_contact(const Island& island, const BodyContactState& memory,
                       const SceneState& state, const std::vector<Course>& courses);

  const Assembly& assembly_;
  double time_step_;
  std::vector<bool> stiff_treads_;
  std::vector<Slip> slips_;
};

}  // namespace gurney
