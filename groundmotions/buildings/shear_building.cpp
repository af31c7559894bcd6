#include "groundmotions/buildings/shear_building.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace gurney::groundmotions {

Eigen::MatrixXd shear_stiffness(const Eigen::VectorXd& storeys) {
  const Eigen::Index n = storeys.size();
  assert(n > 0 && storeys.minCoeff() > 0);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    stiffness(i, i) += storeys[i];
    if (i == 0) continue;
    stiffness(i - 1, i - 1) += storeys[i];
    stiffness(i - 1, i) -= storeys[i];
    stiffness(i, i - 1) -= storeys[i];
  }
  return stiffness;
}

Eigen::VectorXd tapered_storeys(int storeys, double top_ratio) {
  if (storeys == 1) return Eigen::VectorXd::Ones(1);
  return Eigen::VectorXd::LinSpaced(storeys, 1, top_ratio);
}

Eigen::MatrixXd shear_flexure_stiffness(int storeys, double alpha0) {
  assert(storeys > 0 && alpha0 >= 0);
  const Eigen::MatrixXd shear = shear_stiffness(Eigen::VectorXd::Constant(storeys, storeys));
  if (std::isinf(alpha0)) return shear;
  Eigen::MatrixXd flexibility(storeys, storeys);
  for (int i = 0; i < storeys; ++i)
    for (int j = 0; j < storeys; ++j) {
      const double low = (std::min(i, j) + 1.0) / storeys, high = (std::max(i, j) + 1.0) / storeys;
      flexibility(i, j) = low * low * (3 * high - low) / 6;
    }
  const Eigen::MatrixXd bending = flexibility.inverse();
  return (bending + bending.transpose()) / 2 + alpha0 * alpha0 * shear;
}

}  // namespace gurney::groundmotions
