#include "groundmotions/synthetic/end_state.h"

#include <Eigen/LU>
#include <cassert>
#include <numbers>

#include "engine/base/floor_motion.h"

namespace gurney {

Eigen::Vector2d end_state(double time_step, const Eigen::VectorXd& acceleration) {
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, acceleration.size());
  motion.row(0) = acceleration.transpose();
  const FloorMotion floor(time_step, std::move(motion));
  return {floor.residual_velocity().x(), floor.residual_displacement().x()};
}

void set_end_state(double time_step, Eigen::VectorXd& acceleration, const Eigen::Vector2d& wanted) {
  assert(acceleration.size() >= 4);
  const Eigen::ArrayXd phase = Eigen::ArrayXd::LinSpaced(acceleration.size(), 0, std::numbers::pi);
  const Eigen::VectorXd even = phase.sin().square(), odd = phase.sin().square() * phase.cos();
  Eigen::Matrix2d effect;
  effect << end_state(time_step, even), end_state(time_step, odd);
  const Eigen::Vector2d c = effect.inverse() * (end_state(time_step, acceleration) - wanted);
  acceleration -= c[0] * even + c[1] * odd;
}

}  // namespace gurney
