#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "groundmotions/buildings/modal_building.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;

ModalAxis unit_masses(const Eigen::MatrixXd& stiffness) {
  return modes_of(Eigen::VectorXd::Ones(stiffness.rows()), stiffness);
}

// omega_k = 2 sqrt(k / m) sin((2 k - 1) pi / (2 (2 n + 1))), shape sin((2 k - 1) pi j / (2 n + 1)).
TEST(ShearBuilding, UniformStoreysHaveTheClosedForm) {
  for (const int n : {1, 4, 30}) {
    const ModalAxis axis = unit_masses(shear_stiffness(Eigen::VectorXd::Constant(n, 700.0)));
    ASSERT_EQ(axis.size(), static_cast<std::size_t>(n));
    for (int k = 1; k <= n; ++k) {
      const Mode& mode = axis[static_cast<std::size_t>(k - 1)];
      const double phase = (2 * k - 1) * pi / (2 * n + 1);
      EXPECT_NEAR(mode.omega, 2 * std::sqrt(700.0) * std::sin(phase / 2), 1e-11);
      Eigen::VectorXd shape(n);
      for (int j = 1; j <= n; ++j) shape[j - 1] = std::sin(phase * j);
      shape *= shape.sum() / shape.squaredNorm();  // Gamma phi
      EXPECT_NEAR((mode.effective_shape.tail(n) - shape).norm(), 0, 1e-11);
      EXPECT_EQ(mode.effective_shape[0], 0);
    }
  }
}

TEST(ShearBuilding, StoreysTaperLinearly) {
  EXPECT_EQ(tapered_storeys(3, 0.5), Eigen::Vector3d(1, 0.75, 0.5));
  EXPECT_EQ(tapered_storeys(1, 0.5)[0], 1);
}

TEST(ShearBuilding, FirstPeriodIsAsAsked) {
  ModalAxis axis = unit_masses(shear_stiffness(tapered_storeys(5, 0.4)));
  const double ratio = axis[1].omega / axis[0].omega;
  scale_to_period(axis, 0.8);
  EXPECT_NEAR(axis[0].omega, 2 * pi / 0.8, 1e-12);
  EXPECT_NEAR(axis[1].omega / axis[0].omega, ratio, 1e-12);
}

/// Root of the characteristic equation of a uniform cantilever with bending stiffness 1 and shear
/// stiffness alpha^2 (Miranda & Taghavi 2005): gamma_i, with
/// omega_i = gamma_i sqrt(gamma_i^2 + alpha^2).
double characteristic(double gamma, double alpha) {
  const double b = std::sqrt(gamma * gamma + alpha * alpha);
  return 2 + (2 + std::pow(alpha, 4) / std::pow(gamma * b, 2)) * std::cos(gamma) * std::cosh(b) +
         alpha * alpha / (gamma * b) * std::sin(gamma) * std::sinh(b);
}

double root(int mode, double alpha) {
  double low = (mode - 0.999) * pi, high = mode * pi;
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    const bool left = (characteristic(low, alpha) > 0) == (characteristic(middle, alpha) > 0);
    (left ? low : high) = middle;
  }
  return low;
}

// With n floors the mass of a continuum m per height is m / n at j / n, half a storey too high: the
// frequencies are lower by 1 / (2 n) of their power of the height at most (2 for bending), so by 1
// % for n = 100, and by half of that at half the number again.
TEST(ShearBuilding, ManyStoreysAreTheShearFlexureContinuum) {
  EXPECT_NEAR(root(1, 0), 1.8751040687, 1e-9);  // cantilever
  for (const double alpha : {0.0, 2.0, 5.0, 20.0}) {
    const int n = 100;
    const auto floors = [&](int storeys) {
      const Eigen::MatrixXd stiffness = shear_flexure_stiffness(storeys, alpha);
      return modes_of(Eigen::VectorXd::Constant(storeys, 1.0 / storeys), stiffness);
    };
    const ModalAxis axis = floors(n), coarse = floors(n / 2);
    for (int i = 1; i <= 3; ++i) {
      const double gamma = root(i, alpha);
      const double exact = gamma * std::sqrt(gamma * gamma + alpha * alpha);
      const auto k = static_cast<std::size_t>(i - 1);
      EXPECT_NEAR(axis[k].omega / exact, 1, 0.02 + 1e-3 * i) << alpha << ' ' << i;
      EXPECT_NEAR((coarse[k].omega / exact - 1) / (axis[k].omega / exact - 1), 2, 0.1);
    }
  }
}

TEST(ShearBuilding, InfiniteShearFlexureRatioIsTheShearFrame) {
  const ModalAxis shear =
      unit_masses(shear_flexure_stiffness(6, std::numeric_limits<double>::infinity()));
  const ModalAxis near = unit_masses(shear_flexure_stiffness(6, 1e4));
  EXPECT_NEAR(near[1].omega / near[0].omega, shear[1].omega / shear[0].omega, 1e-4);
}

}  // namespace
}  // namespace gurney::groundmotions
