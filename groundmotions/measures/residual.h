#pragma once

#include <string>
#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/base/vector.h"

namespace gurney::groundmotions {

/// A residual velocity that is visible however long the record [m/s].
inline constexpr double kVisibleVelocity = 0.05;

/// What a floor motion leaves at its end, and whether that is plausible.
///
/// An item on casters integrates the floor's acceleration twice by itself. In a prototype of this
/// engine a baseline error of 0.001 g moved a trolley's peak displacement from 0.38 to 0.56 m. If
/// the effect is linear (an assumption), 0.0001 g is worth some 5 % of the peak. Two rules, on the
/// horizontal resultants, with T the duration of the record:
///
/// 1. |v_residual| > clamp(0.0001 g T, 0.01 m/s, 0.05 m/s): the mean acceleration of the
///    record, v_residual / T, is a baseline error that matters. Below 0.01 m/s what is left moves
///    nothing visibly; 0.05 m/s is visible however long the record.
/// 2. |d_residual| > 0.05 m and > half the largest floor displacement: the floor does not come
///    back. This is real for permanent ground displacement near a fault, and otherwise a
///    baseline error.
struct Residual {
  Vector3 velocity = Vector3::Zero();      ///< at the last sample, from rest at the first [m/s]
  Vector3 displacement = Vector3::Zero();  ///< likewise [m]
  std::vector<std::string> warnings;       ///< one for each rule that is broken
};

Residual residual(const FloorMotion& floor);

}  // namespace gurney::groundmotions
