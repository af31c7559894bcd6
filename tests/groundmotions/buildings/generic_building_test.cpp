#include "groundmotions/buildings/generic_building.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace gurney {
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

}  // namespace
}  // namespace gurney
