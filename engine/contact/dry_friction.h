#pragma once

#include "engine/base/lanes.h"

namespace gurney {

/// Stuck bearings, brakes, locks and rolling resistances are this much stiffer than the tread they
/// act through at its lever arm.
inline constexpr double kStickStiffnessRatio = 10;

/// Dry friction of one rotating joint or one rolling direction, with real stick: an elastic-plastic
/// element whose stored deflection z [rad] is its memory. Over an implicit stage of length tau
///
///     T_trial = -k (z + tau w),   T = clamp(T_trial, -limit, +limit) - c w,   z_new = -T_dry / k
///
/// (return mapping, Simo & Hughes 1998, chapter 1). Below the limit nothing creeps, however long
/// the load lasts: the joint only winds up by limit / k. The stiffness k is numerical; it is chosen
/// far above the compliance of the tread, so that the deflection is invisible.
template <class T>
struct DryFrictionOf {
  T stiffness{};  ///< k > 0 [N m/rad]
  T viscous{};    ///< c >= 0 [N m s/rad]

  struct Result {
    T torque{};       ///< on the joint, along +w [N m]
    T rate_slope{};   ///< -dT/dw >= 0 [N m s/rad]
    T limit_slope{};  ///< dT/dlimit: -1, 0 or 1
    T deflection{};   ///< z at the end of the stage [rad]
    Mask<T> slips{};
  };

  /// @param deflection  z at the start of the stage [rad]
  /// @param rate        w at its end [rad/s]
  /// @param limit       largest dry torque, >= 0, may be infinite [N m]
  Result evaluate(const T& deflection, const T& rate, const T& limit, const T& tau) const {
    Result result;
    const T trial = -stiffness * (deflection + tau * rate);
    const Mask<T> sticks = (limit > T{}) & (abs(trial) <= limit);
    const T dry = select(sticks, trial, copysign(limit, trial));
    result.rate_slope = select(sticks, stiffness * tau, T{}) + viscous;
    result.limit_slope = select(sticks, T{}, copysign(splat<T>(1), trial));
    result.slips = !sticks;
    result.deflection = -dry / stiffness;
    result.torque = dry - viscous * rate;
    return result;
  }
};

using DryFriction = DryFrictionOf<double>;

}  // namespace gurney
