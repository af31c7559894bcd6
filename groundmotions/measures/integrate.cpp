#include "groundmotions/measures/integrate.h"

namespace gurney::groundmotions {

IntegratedMotion integrated(double time_step, const Eigen::VectorXd& acceleration) {
  const Eigen::Index samples = acceleration.size();
  IntegratedMotion motion{Eigen::VectorXd::Zero(samples), Eigen::VectorXd::Zero(samples)};
  for (Eigen::Index i = 1; i < samples; ++i) {
    const double a0 = acceleration[i - 1], a1 = acceleration[i], v0 = motion.velocity[i - 1];
    motion.velocity[i] = v0 + time_step / 2 * (a0 + a1);
    motion.displacement[i] =
        motion.displacement[i - 1] + time_step * v0 + time_step * time_step / 6 * (2 * a0 + a1);
  }
  return motion;
}

EndMotion end_motion(double time_step, const Eigen::VectorXd& acceleration) {
  if (acceleration.size() == 0) return {};
  const IntegratedMotion motion = integrated(time_step, acceleration);
  return {motion.velocity[acceleration.size() - 1], motion.displacement[acceleration.size() - 1]};
}

}  // namespace gurney::groundmotions
