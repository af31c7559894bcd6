#pragma once

#include "engine/caster/caster_dynamics.h"

namespace gurney {

/// x of a x = b by LU with partial pivoting, every operation that of Eigen's partialPivLu in its
/// order, all sizes known to the compiler: a fifth of its instructions.
Vector6 solve6(const Matrix6& a, const Vector6& b);

}  // namespace gurney
