#include "groundmotions/measures/peaks.h"

#include <cassert>

#include "groundmotions/measures/integrate.h"

namespace gurney::groundmotions {

Peaks peaks(double time_step, const Eigen::VectorXd& a) {
  if (a.size() == 0) return {};
  const IntegratedMotion motion = integrated(time_step, a);
  Eigen::Index at = 0;
  const double largest = a.cwiseAbs().maxCoeff(&at);
  return {largest, motion.velocity.cwiseAbs().maxCoeff(), motion.displacement.cwiseAbs().maxCoeff(),
          static_cast<double>(at) * time_step};
}

Peaks peaks(double time_step, const Eigen::VectorXd& h1, const Eigen::VectorXd& h2) {
  assert(h1.size() == h2.size());
  if (h1.size() == 0) return {};
  const IntegratedMotion one = integrated(time_step, h1), two = integrated(time_step, h2);
  const auto length = [](const Eigen::VectorXd& x, const Eigen::VectorXd& y) -> Eigen::VectorXd {
    return (x.array().square() + y.array().square()).sqrt();
  };
  Eigen::Index at = 0;
  const double largest = length(h1, h2).maxCoeff(&at);
  return {largest, length(one.velocity, two.velocity).maxCoeff(),
          length(one.displacement, two.displacement).maxCoeff(),
          static_cast<double>(at) * time_step};
}

}  // namespace gurney::groundmotions
