#pragma once

#include <algorithm>
#include <cmath>

namespace gurney {

/// Dry friction of one rotating joint or one rolling direction, with real stick: an elastic-plastic
/// element whose stored deflection z [rad] is its memory. Over an implicit stage of length tau
///
///     T_trial = -k (z + tau w),   T = clamp(T_trial, -limit, +limit) - c w,   z_new = -T_dry / k
///
/// (return mapping, Simo & Hughes 1998, chapter 1). Below the limit nothing creeps, however long
/// the load lasts: the joint only winds up by limit / k. The stiffness k is numerical; it is chosen
/// far above the compliance of the tread, so that the deflection is invisible.
struct DryFriction {
  double stiffness = 0;  ///< k > 0 [N m/rad]
  double viscous = 0;    ///< c >= 0 [N m s/rad]

  struct Result {
    double torque = 0;       ///< on the joint, along +w [N m]
    double rate_slope = 0;   ///< -dT/dw >= 0 [N m s/rad]
    double limit_slope = 0;  ///< dT/dlimit: -1, 0 or 1
    double deflection = 0;   ///< z at the end of the stage [rad]
    bool slips = false;
  };

  /// @param deflection  z at the start of the stage [rad]
  /// @param rate        w at its end [rad/s]
  /// @param limit       largest dry torque, >= 0, may be infinite [N m]
  Result evaluate(double deflection, double rate, double limit, double tau) const {
    Result result;
    const double trial = -stiffness * (deflection + tau * rate);
    double dry = trial;
    if (limit > 0 && std::abs(trial) <= limit) {
      result.rate_slope = stiffness * tau;
    } else {
      dry = std::copysign(limit, trial);
      result.limit_slope = std::copysign(1.0, trial);
      result.slips = true;
    }
    result.deflection = -dry / stiffness;
    result.torque = dry - viscous * rate;
    result.rate_slope += viscous;
    return result;
  }
};

}  // namespace gurney
