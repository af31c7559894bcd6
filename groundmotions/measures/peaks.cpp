#include "groundmotions/measures/peaks.h"

#include <algorithm>
#include <cmath>

namespace gurney {

Peaks peaks(double time_step, const Eigen::VectorXd& acceleration) {
  Peaks result;
  double velocity = 0, displacement = 0;
  for (Eigen::Index i = 0; i < acceleration.size(); ++i) {
    if (i > 0) {
      const double a0 = acceleration[i - 1], a1 = acceleration[i];
      displacement += time_step * velocity + time_step * time_step / 6 * (2 * a0 + a1);
      velocity += time_step / 2 * (a0 + a1);
    }
    if (std::abs(acceleration[i]) > result.acceleration) {
      result.acceleration = std::abs(acceleration[i]);
      result.time_of_acceleration = static_cast<double>(i) * time_step;
    }
    result.velocity = std::max(result.velocity, std::abs(velocity));
    result.displacement = std::max(result.displacement, std::abs(displacement));
  }
  return result;
}

}  // namespace gurney
