#pragma once

#include <limits>
#include <optional>

#include "engine/base/units.h"
#include "engine/response/demands.h"

namespace gurney {

/// How far the motion of one item follows from its inputs: what became of a change of them that
/// nobody can measure. A twin of the run, whose items are heavier by 1e-9 (engine/scene/perturbed.h),
/// parts from it; s(t) is the largest of the differences of displacement, tilt and yaw at t, each
/// over its peak (docs/theory/predictability.md).
struct Predictability {
  /// Amplification from which a change of 1e-3, below what masses and frictions are known to, or an
  /// error of the time step of that size, would change the motion by its own size.
  static constexpr double kSensitive = 1e3;
  /// Amplification at which the twin itself has parted visibly: s = 1 %.
  static constexpr double kChaotic = 1e7;

  /// Peaks below these count as rest: nobody measures or asks for less [m], [rad].
  static constexpr double kLeastDisplacement = 1e-3, kLeastTilt = 0.1 * kRadiansPerDegree,
                          kLeastYaw = 1 * kRadiansPerDegree;

  enum class Verdict { kPredictable, kSensitive, kChaotic };

  /// By the amplification when the item has reached its peaks of displacement and tilt, or has
  /// overturned; kChaotic also where only one of run and twin overturns.
  Verdict verdict = Verdict::kPredictable;
  double amplification = 0;  ///< max s(t) / 1e-9 over the run
  double amplification_at_peaks = 0;
  double time_of_peaks = 0;  ///< the later peak, or the overturning [s]
  /// From when on the amplification has reached kSensitive; NaN: never [s].
  double horizon = std::numeric_limits<double>::quiet_NaN();

  /// Demands of the twin, and of the same run with half the time step and an eighth of the tolerance;
  /// none: that run failed. They judge each demand: engine/response/settled.h.
  std::optional<Demands> twin, half_step;
  /// Change with half the step that its demands count as having at least (as SettledDemand::least_change)
  /// because of the items that it may meet.
  double change_of_neighbours = 0;
};

const char* name_of(Predictability::Verdict verdict);

}  // namespace gurney
