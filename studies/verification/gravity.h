#pragma once

#include "engine/base/units.h"

namespace gurney {

/// Gravity of every case that does not state its own [m/s2].
inline constexpr double kG = kStandardGravity;

}  // namespace gurney
