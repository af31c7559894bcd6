#include "groundmotions/synthetic/end_state.h"

#include <Eigen/LU>
#include <cassert>
#include <numbers>

#include "groundmotions/measures/integrate.h"

namespace gurney::groundmotions {

Eigen::Vector2d end_state(double time_step, const Eigen::VectorXd& acceleration) {
  const EndMotion end = end_motion(time_step, acceleration);
  return {end.velocity, end.displacement};
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

Eigen::VectorXd acceleration_of(double time_step, const Eigen::VectorXd& displacement) {
  assert(displacement.size() >= 4);
  // Rows (1 4 1), at the ends (2 1) and (1 2), of the second differences; elimination downwards
  // and substitution upwards.
  const Eigen::Index last = displacement.size() - 1;
  const double factor = 6 / (time_step * time_step);
  Eigen::VectorXd a(last + 1), upper(last + 1);
  upper[0] = 0.5;
  a[0] = factor * (displacement[1] - displacement[0]) / 2;
  for (Eigen::Index i = 1; i <= last; ++i) {
    const double forward = i < last ? displacement[i + 1] - displacement[i] : 0;
    const double pivot = (i < last ? 4 : 2) - upper[i - 1];
    upper[i] = 1 / pivot;
    a[i] = (factor * (forward - (displacement[i] - displacement[i - 1])) - a[i - 1]) / pivot;
  }
  for (Eigen::Index i = last; i-- > 0;) a[i] -= upper[i] * a[i + 1];
  return a;
}

}  // namespace gurney::groundmotions
