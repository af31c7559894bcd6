#include "groundmotions/buildings/modal_building.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "engine/base/random/normal_draw.h"
#include "tests/groundmotions/buildings/matrix_exponential.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;

const Eigen::Vector3d kMass(2e5, 3e5, 1e5);
const Eigen::Vector3d kStoreys(9e8, 5e8, 2e8);

ModalAxis uneven_building() { return modes_of(kMass, shear_stiffness(kStoreys)); }

TEST(ModalBuilding, EffectiveMassesAndShapesAddUpToOne) {
  double mass = 0;
  Eigen::VectorXd shape = Eigen::VectorXd::Zero(4);
  for (const Mode& mode : uneven_building()) {
    mass += mode.effective_mass;
    shape += mode.effective_shape;
  }
  EXPECT_NEAR(mass, 1, 1e-13);
  EXPECT_NEAR((shape - Eigen::Vector4d(0, 1, 1, 1)).norm(), 0, 1e-13);
}

// Under a constant base acceleration the displacement settles at K^-1 M 1 a, which the modes give
// as the sum of effective shapes over omega^2.
TEST(ModalBuilding, StaticDisplacementIsThatOfTheStiffness) {
  const Eigen::Vector3d exact = shear_stiffness(kStoreys).inverse() * kMass;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(4);
  for (const Mode& mode : uneven_building())
    sum += mode.effective_shape / (mode.omega * mode.omega);
  EXPECT_NEAR((sum.tail(3) - exact).norm(), 0, 1e-12 * exact.norm());
}

TEST(ModalBuilding, RayleighDampingIsThatOfTheMatrices) {
  ModalAxis axis = uneven_building();
  set_rayleigh_damping(axis, 0.04, 0, 2);
  EXPECT_NEAR(axis[0].damping, 0.04, 1e-15);
  EXPECT_NEAR(axis[2].damping, 0.04, 1e-15);
  const double a = axis[0].omega, b = axis[2].omega;
  const double alpha = 2 * 0.04 * a * b / (a + b), beta = 2 * 0.04 / (a + b);
  EXPECT_NEAR(axis[1].damping, alpha / (2 * axis[1].omega) + beta * axis[1].omega / 2, 1e-15);
}

// Independent method: the whole state space x' = A x + B a(t) with Rayleigh damping as matrices,
// and exp of the system with a and its slope as two more states, exact for a linear between
// samples. Both are exact, so they differ by rounding over 400 steps only.
TEST(ModalBuilding, FloorsFollowTheMatrixExponential) {
  ModalAxis axis = uneven_building();
  set_rayleigh_damping(axis, 0.04, 0, 1);
  const double a = axis[0].omega, b = axis[1].omega, h = 0.013;
  const Eigen::Matrix3d stiffness = shear_stiffness(kStoreys);
  const Eigen::Matrix3d mass = kMass.asDiagonal();
  const Eigen::Matrix3d damping = 2 * 0.04 / (a + b) * (a * b * mass + stiffness);
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(8, 8);
  system.block<3, 3>(0, 3).setIdentity();
  system.block<3, 3>(3, 0) = -mass.inverse() * stiffness;
  system.block<3, 3>(3, 3) = -mass.inverse() * damping;
  system.block<3, 1>(3, 6).setConstant(-1);
  system(6, 7) = 1;
  const Eigen::MatrixXd advance = matrix_exponential(system * h);

  Eigen::VectorXd state = Eigen::VectorXd::Zero(8);
  std::array responses = {ModalResponse(axis, 1, h), ModalResponse(axis, 2, h),
                          ModalResponse(axis, 3, h)};
  double base = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    const double next = normal_draw(5, 0, i);
    state[6] = base;
    state[7] = (next - base) / h;
    state = advance * state;
    const Eigen::Vector3d exact = system.block<3, 6>(3, 0) * state.head(6);
    for (int floor = 0; floor < 3; ++floor)
      EXPECT_NEAR(responses[static_cast<std::size_t>(floor)].step(base, next), exact[floor], 1e-10);
    base = next;
  }
}

// Steady state under a_base = sin(W t) against a + sum S (W^2 / (w^2 - W^2 + 2 i z w W)) a. The
// base is linear between samples: its fundamental is smaller by sinc^2(W h / 2), 1 - (W h)^2 / 12 =
// 1 - 3e-7 here, and the rest (its harmonics) is smaller still: 1e-6 of the amplitude.
TEST(ModalBuilding, SteadyStateIsTheTransferFunction) {
  ModalAxis axis = uneven_building();
  set_damping(axis, 0.05);
  for (const double ratio : {0.5, 1.0, 2.7}) {
    const double w = ratio * axis[0].omega, h = 0.002 / w;
    std::complex<double> gain = 1;
    for (const Mode& mode : axis)
      gain +=
          mode.effective_shape[3] * w * w /
          std::complex<double>(mode.omega * mode.omega - w * w, 2 * mode.damping * mode.omega * w);
    ModalResponse roof(axis, 3, h);
    const int cycle = static_cast<int>(std::lround(2 * pi / (w * h)));
    double worst = 0;
    for (int i = 0; i < 90 * cycle; ++i) {  // exp(-0.05 x 2 pi x 90 / 2.7) = 3e-5 at the worst
      const double base1 = std::sin(w * h * (i + 1));
      const double roof1 = roof.step(std::sin(w * h * i), base1);
      const double exact = std::imag(gain * std::polar(1.0, w * h * (i + 1)));
      if (i >= 89 * cycle) worst = std::max(worst, std::abs(roof1 - exact));
    }
    EXPECT_LT(worst, 1e-4 * std::abs(gain)) << ratio;
  }
}

// What is left out follows the base: at a frequency far below all of them the floor moves as the
// base, whatever number of modes is kept.
TEST(ModalBuilding, ModesLeftOutAreRigid) {
  ModalAxis axis = uneven_building();
  set_damping(axis, 0.05);
  ModalResponse all(axis, 2, 0.01), first({axis[0]}, 2, 0.01), none({}, 2, 0.01);
  double a = 0, b = 0, c = 0;
  for (int i = 0; i < 4000; ++i) {
    a = all.step(1, 1);
    b = first.step(1, 1);
    c = none.step(1, 1);
  }
  EXPECT_NEAR(a, 1, 1e-12);
  EXPECT_NEAR(b, 1, 1e-12);
  EXPECT_EQ(c, 1);
}

TEST(ModalBuilding, FloorZeroIsTheBase) {
  ModalAxis axis = uneven_building();
  set_damping(axis, 0.05);
  ModalResponse base(axis, 0, 0.01);
  EXPECT_EQ(base.step(0, 3.25), 3.25);
  EXPECT_EQ(base.step(3.25, -1), -1);
}

// 1e4 Hz against a load of 1 Hz: relative acceleration (W / w)^2 = 1e-8 of the base's, times at
// most 2 for the start of the slope, which is damped away slowly.
TEST(ModalBuilding, AStiffBuildingMovesAsTheGround) {
  ModalAxis axis = uneven_building();
  scale_to_period(axis, 1e-4);
  set_damping(axis, 0.05);
  ModalResponse roof(axis, 3, 0.01);
  for (int i = 0; i < 100; ++i) {
    const double base1 = std::pow(std::sin(pi * 0.01 * (i + 1)), 2);
    EXPECT_NEAR(roof.step(std::pow(std::sin(pi * 0.01 * i), 2), base1), base1, 1e-4);
  }
}

}  // namespace
}  // namespace gurney::groundmotions
