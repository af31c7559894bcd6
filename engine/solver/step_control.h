#pragma once

#include <limits>
#include <vector>

#include "engine/scene/settings.h"
#include "engine/solver/assembly.h"
#include "engine/solver/island.h"
#include "engine/solver/slip_reversal.h"
#include "engine/solver/stage_solver.h"

namespace gurney {

/// Steps as long as their own error allows (docs/theory/solver.md). With the accelerations
/// a_0 at the start of a step and a_1, a_2 of its stages, the error of the velocity is
///
///     d = 2/3 h (a_1 - (1 - gamma) a_0 - gamma a_2),
///
/// exact to leading order for linear motion. A step is taken when d is below a share of the
/// tolerance times the largest speed of the item so far; else it is tried again, shorter.
class StepControl {
 public:
  /// Errors of the steps of a motion to and fro add up like a random walk: those of the 1e4 steps
  /// of a run of 20 s by 100.
  static constexpr double kShareOfStep = 0.01;
  /// Shortest step, as a share of settings.time_step.
  static constexpr double kShortest = 1.0 / 256;

  StepControl(const Assembly& assembly, const SimulationSettings& settings);

  bool on() const { return tolerance_ > 0; }

  /// The longest next step of all items of the island; infinite while off [s].
  double longest(const Island& island) const;

  /// Outcome of a tried step of an island.
  struct Trial {
    const Island& island;
    double duration;
    bool converged;
    const SceneState& from;
    const std::vector<SlipReversals::Course>& courses;  ///< of all items, before the step
    const StageSolver::Output &first, &end;
  };

  /// Judges a step and chooses the next one, or the one that replaces it.
  bool rejects(const Trial& trial);

  /// d of the chassis [m/s], [rad/s].
  static Vector6 velocity_error(double duration, const Vector6& at_start, const Vector6& first,
                                const Vector6& end);

 private:
  double error(const Trial& trial, std::size_t item);

  const Assembly& assembly_;
  double tolerance_, shortest_;
  struct Course {
    double longest = std::numeric_limits<double>::infinity();  ///< [s]
    double top_speed;                                          ///< so far, anywhere [m/s]
  };
  std::vector<Course> items_;
};

}  // namespace gurney
