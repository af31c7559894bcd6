#include "tests/peers/cross_check.h"

#include <cmath>

namespace gurney::peers {

Snapshot snapshot(const Vector3& origin, const Matrix3& rotation) {
  return {{origin.x(), origin.y(), std::atan2(rotation(1, 0), rotation(0, 0))},
          std::atan2(rotation.col(2).head<2>().norm(), rotation(2, 2))};
}

}  // namespace gurney::peers
