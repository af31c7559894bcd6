#pragma once

#include <vector>

#include "engine/base/vector.h"

namespace gurney {

/// A contact of the item with something else than wheel on floor, as Bullet reported it.
struct BodyContact {
  enum class Body { kChassis, kFork, kWheel };
  Body body = Body::kChassis;
  int leg = -1;                       ///< of kFork and kWheel
  Vector3 point = Vector3::Zero();    ///< on the item, floor axes relative to the chassis' centre
  Vector3 normal = Vector3::UnitZ();  ///< unit, towards the item, floor axes
  double gap = 0;                     ///< along the normal; negative: overlap [m]
};

}  // namespace gurney
