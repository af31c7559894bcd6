#include "tests/peers/cross_check.h"

#include <cmath>

namespace gurney::peers {

Snapshot snapshot(const Vector3& origin, const Matrix3& rotation) {
  return {{origin.x(), origin.y(), std::atan2(rotation(1, 0), rotation(0, 0))},
          std::atan2(rotation.col(2).head<2>().norm(), rotation(2, 2))};
}

CrossCheck along_x(CrossCheck check) {
  for (Caster& caster : check.scene.items[0].model.casters) caster.heading = 0;
  Eigen::Matrix3Xd acceleration = check.floor.acceleration();
  acceleration.row(1).setZero();
  check.floor = FloorMotion(check.floor.time_step(), acceleration);
  return check;
}

}  // namespace gurney::peers
