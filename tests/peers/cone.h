#pragma once

#include "engine/base/vector.h"

namespace gurney::peers {

/// One contact among others: u = start + block p with the impulse p, of which p_z >= 0 is a linear
/// function of u_z already in block and start: p_z > 0 only where (start + block p)_z = 0.
struct ContactBlock {
  Matrix3 block;
  Vector3 start;
  double friction;
};

/// The impulse of Coulomb's exact cone: it sticks, or slides with |p_t| = mu p_z against u_t.
Vector3 cone_impulse(const ContactBlock& contact);

}  // namespace gurney::peers
