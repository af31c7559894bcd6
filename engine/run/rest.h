#pragma once

#include <vector>

#include "engine/base/vector.h"
#include "engine/scene/scene.h"

namespace gurney {

/// An item, a part or a content where all has come to rest, before the floor moves.
struct RestingBody {
  Vector3 origin = Vector3::Zero();                 ///< of its item axes, floor axes [m]
  Quaternion orientation = Quaternion::Identity();  ///< of them
  double coordinate = 0;  ///< of a part: q, or without one its angle from its base [m], [rad]
};

/// As Scene::items.
/// @throws Error where an item does not come to rest
std::vector<RestingBody> at_rest(const Scene& scene);

}  // namespace gurney
