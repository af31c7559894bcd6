
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "groundmotions/buildings/modal_building.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;

// The table in feet: 0.028 h^0.8, 0.016 h^0.9, 0.03 h^0.75, 0.02 h^0.75; 40 ft = 12.192 m. The two
// forms agree to the three digits the metric ones have.
TEST(GenericBuilding, ApproximatePeriodIsThatOfTheTableInFeet) {
  const double feet[] = {0.028 * std::pow(40, 0.8), 0.016 * std::pow(40, 0.9),
                         0.03 * std::pow(40, 0.75), 0.03 * std::pow(40, 0.75),
                         0.02 * std::pow(40, 0.75)};
  for (std::size_t i = 0; i < kFrameKinds.size(); ++i)
    EXPECT_NEAR(approximate_period(kFrameKinds[i], 12.192) / feet[i], 1, 2e-3)
        << kFrameKinds[i].name;
}

// First mode sin(pi x / a) sin(pi y / b): means 4 / pi^2, squares 1 / 4; Gamma phi(centre) =
// (4 / pi^2) / (1 / 4), share (4 / pi^2)^2 / (1 / 4).
TEST(GenericBuilding, PlateHasItsClosedForm) {
  EXPECT_NEAR(plate_participation(), 16 / (pi * pi), 1e-15);
  EXPECT_NEAR(plate_mass_share(), 64 / std::pow(pi, 4), 1e-15);
}

VerticalFloors floors(double columns) {
  return {.floor_omega = 60,
          .column_omega = columns,
          .damping = 0.03,
          .mass_share = plate_mass_share(),
          .participation = plate_participation()};
}

TEST(GenericBuilding, OnRigidColumnsEveryFloorIsOneOscillator) {
  const ModalAxis axis = vertical_modes(3, floors(std::numeric_limits<double>::infinity()));
  ASSERT_EQ(axis.size(), 1U);
  EXPECT_EQ(axis[0].omega, 60);
  EXPECT_EQ(axis[0].damping, 0.03);
  const Eigen::Vector4d shape = Eigen::Vector4d(0, 1, 1, 1) * 16 / (pi * pi);
  EXPECT_NEAR((axis[0].effective_shape - shape).norm(), 0, 1e-15);
}

// Columns 1000 times as stiff as the slab move by (w / W)^2 of it: 1e-6. What the slabs' modes do
// together is then the one oscillator; they differ in frequency by as little.
TEST(GenericBuilding, StiffColumnsApproachRigidOnes) {
  const ModalAxis axis = vertical_modes(3, floors(6e4));
  ASSERT_EQ(axis.size(), 6U);
  Eigen::Vector4d shape = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(axis[i].omega, 60, 60 * 1e-5);
    shape += axis[i].effective_shape;
  }
  EXPECT_NEAR((shape - axis[0].effective_shape[0] * shape).tail(3).mean(), plate_participation(),
              1e-5);
}

// Slabs 1000 times as stiff as the columns are rigid: the first mode is that of the columns.
TEST(GenericBuilding, StiffSlabsRideOnTheColumns) {
  VerticalFloors stiff = floors(60);
  stiff.floor_omega = 6e4;
  const ModalAxis axis = vertical_modes(3, stiff);
  EXPECT_NEAR(axis[0].omega, 60, 60 * 1e-5);
  double sum = 0;
  for (const Mode& mode : axis) sum += mode.effective_shape[2];
  EXPECT_NEAR(sum, 1, 1e-9);
}

// First mode of a uniform cantilever, cosh - cos - s (sinh - sin) of b z / H with b = 1.8751 and
// s = 0.7341 (Blevins 1979, Table 8-1): slope over displacement at the free end,
// b (sinh + sin - s (cosh - cos)) / (cosh - cos - s (sinh - sin)) = 1.3765 / H. The n lumped floors
// put half a storey's mass too much at the top and differ by O(1 / n): the error halves with n.
TEST(GenericBuilding, RoofOfACantileverDipsAsTheClosedForm) {
  const double b = 1.87510407, s = 0.73409551, height = 20;
  const double exact = b * (std::sinh(b) + std::sin(b) - s * (std::cosh(b) - std::cos(b))) /
                       (std::cosh(b) - std::cos(b) - s * (std::sinh(b) - std::sin(b)));
  EXPECT_NEAR(exact, 1.3765, 1e-4);
  const auto error = [&](int n) {
    ModalAxis axis = modes_of(Eigen::VectorXd::Ones(n), shear_flexure_stiffness(n, 0));
    set_rotation(axis, height, 1);
    return axis[0].effective_rotation[n] / axis[0].effective_shape[n] * height / exact - 1;
  };
  EXPECT_LT(std::abs(error(40)), 1.0 / 40);
  EXPECT_LT(std::abs(error(80)), 0.6 * std::abs(error(40)) + 1e-6);
}

TEST(GenericBuilding, FloorsRotateByTheSlopeOfTheModeShape) {
  ModalAxis axis = modes_of(Eigen::VectorXd::Ones(3), shear_flexure_stiffness(3, 2));
  axis[0].effective_shape = Eigen::Vector4d(0, 1, 4, 9);  // a parabola, 1 a square storey
  set_rotation(axis, 6, 0.5);
  EXPECT_LT((axis[0].effective_rotation - Eigen::Vector4d(0, 0.5, 1, 1.5)).norm(), 1e-15);
}

}  // namespace
}  // namespace gurney::groundmotions
