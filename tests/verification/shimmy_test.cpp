#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <ostream>
#include <vector>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/small_scenes.h"

// Shimmy of a caster whose pivot is led along x at v and held across by a spring k. Caster of mass
// m, its centre of mass a behind the pivot, yaw inertia Ic about it, trail L; the pivot carries a
// mass M. With the pivot at y, the heading theta and the lateral force F of the floor
//
//     (M + m) y'' - m a theta'' = F - k y,     (Ic + m a^2) theta'' - m a y'' = -L F
//
// and a wheel that does not slip sideways, y' = L theta' + v theta. Without F and y:
//
//     [Ic + m (L - a)^2 + M L^2] theta''' + [m (L - a) + M L] v theta'' + k L^2 theta'
//                                                                            + k L v theta = 0
//
// M = 0 is the massless pivot of textbooks (after Den Hartog, Mechanical Vibrations). By Routh it
// is stable if Ic < m a (L - a), for every k, v and also M: the terms of M cancel. The spin of the
// wheel gives a moment I_w (v / R) theta' about x only, which the guide of the pivot takes.
namespace gurney {
namespace {

constexpr double kTread = 1e9, kStart = 1e-4;
constexpr int kCount = 600, kSettled = 80;  // steps of a run, and of these those not looked at

struct Case {
  double mass, trail, center;  ///< m, L, a
  double inertia;              ///< Ic / (m a (L - a))
  double spring, speed;        ///< k, v
  double pivot_mass;           ///< M
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << "m " << c.mass << ", L " << c.trail << ", a " << c.center << ", Ic / critical "
       << c.inertia << ", k " << c.spring << ", v " << c.speed << ", M " << c.pivot_mass;
}

double inertia_of(const Case& c) { return c.inertia * c.mass * c.center * (c.trail - c.center); }

/// (theta, theta', theta'')' = A (...)
Eigen::MatrixXd rigid_wheel(const Case& c) {
  const double l = c.trail, b = l - c.center, m = c.mass;
  const double leading = inertia_of(c) + m * b * b + c.pivot_mass * l * l;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(3, 3);
  a(0, 1) = a(1, 2) = 1;
  a.row(2) << -c.spring * l * c.speed / leading, -c.spring * l * l / leading,
      -(m * b + c.pivot_mass * l) * c.speed / leading;
  return a;
}

/// (y, theta, y', theta', e)' = A (...) with a tread of stiffness kTread that is deflected by e:
/// e' = y' - L theta' - v theta, F = -kTread e.
Eigen::MatrixXd elastic_tread(const Case& c) {
  const double l = c.trail;
  Matrix2 mass;
  mass << c.pivot_mass + c.mass, -c.mass * c.center, -c.mass * c.center,
      inertia_of(c) + c.mass * c.center * c.center;
  const Matrix2 compliance = mass.inverse();
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(5, 5);
  a(0, 2) = a(1, 3) = 1;
  a.block<2, 1>(2, 0) = compliance * Vector2(-c.spring, 0);
  a.block<2, 1>(2, 4) = compliance * Vector2(-kTread, l * kTread);
  a.row(4) << 0, -c.speed, 1, -l, 0;
  return a;
}

/// Of the exponents of a real system the one that oscillates with less than 1000 rad/s.
std::complex<double> oscillation(const Eigen::VectorXcd& exponents) {
  std::complex<double> found = 0;
  for (const auto& e : exponents)
    if (e.imag() > found.imag() && e.imag() < 1000) found = e;
  return found;
}

TEST(ShimmyEquation, GivesTheKnownRootsOfAMasslessPivot) {
  // m = 1, L = 0.05, a = 0.03, k = 2e4, v = 1: growth [1/s] and frequency [Hz], to their digits.
  const double rows[][3] = {
      {0.5, -4.262, 42.48}, {0.9, -0.634, 36.70}, {1, 0, 35.588}, {3, 5.362, 24.09}};
  for (const auto& [inertia, growth, frequency] : rows) {
    const auto root = oscillation(rigid_wheel({1, 0.05, 0.03, inertia, 2e4, 1, 0}).eigenvalues());
    EXPECT_NEAR(root.real(), growth, 6e-4) << inertia;
    EXPECT_NEAR(root.imag() / (2 * std::numbers::pi), frequency, 6e-3) << inertia;
  }
}

class Shimmy : public testing::TestWithParam<Case> {
 protected:
  std::vector<double> swivel_angles(double step) const {
    const Case& c = GetParam();
    auto towed = small::towed_caster(c.speed, c.trail, kStart / kRadiansPerDegree,
                                     small::bare_tread(1e6, kTread));
    towed.excitation.fixture.guides[1] = {Guide::Kind::kSpring, 0, c.spring, 0};
    // At the critical inertia the start alone moves the pivot by nothing: a push does.
    towed.excitation.forces = {{"push",
                                {0, 0, 0.15},
                                {0, 1, 0},
                                {0, 0.5 * kSettled * step},
                                {kStart * c.trail * c.spring, kStart * c.trail * c.spring}}};
    EquipmentModel& item = towed.scene.items[0].model;
    item.chassis_mass = c.pivot_mass;
    item.chassis_center_of_mass = {0, 0, 0.15};
    item.chassis_inertia = 0.01 * c.pivot_mass * Matrix3::Identity();
    Caster& caster = item.casters[0];
    caster.tread.relaxation_length = 1e9;
    caster.wheel_mass = 0.05 * c.mass;
    caster.wheel_axial_inertia = 0.02 * inertia_of(c);
    caster.wheel_transverse_inertia = 0.02 * inertia_of(c);
    caster.fork_mass = c.mass - caster.wheel_mass;
    const double center = (c.mass * c.center - caster.wheel_mass * c.trail) / caster.fork_mass;
    caster.fork_center_of_mass = {-center, 0, -0.05};
    const double yaw = inertia_of(c) - caster.wheel_transverse_inertia -
                       caster.wheel_mass * std::pow(c.trail - c.center, 2) -
                       caster.fork_mass * std::pow(center - c.center, 2);
    caster.fork_inertia = yaw * Matrix3::Identity();
    auto settings = small::settings_for(step, kCount * step);
    settings.residual = 1e-12;  // the forces of the start are 1e-4 of the weight
    const Response response = simulate(towed.scene, towed.excitation, settings);
    EXPECT_NE(response.outcome, Outcome::kDiverged) << response.cause;
    std::vector<double> angles;
    for (const Sample& sample : response.items[0].history)
      angles.push_back(sample.wheels[0].swivel_angle);
    return angles;
  }
};

TEST_P(Shimmy, GrowsOrDecaysAsTheCubicSays) {
  const Case& c = GetParam();
  const auto exact = oscillation(rigid_wheel(c).eigenvalues());
  if (c.inertia != 1) {
    EXPECT_EQ(exact.real() > 0, c.inertia > 1);
  } else {
    EXPECT_NEAR(exact.real(), 0, 1e-9 * std::abs(exact));
  }
  // 1e9 N/m is rigid: the spring is 1e-4 of it at most.
  const auto elastic = oscillation(elastic_tread(c).eigenvalues());
  EXPECT_LT(std::abs(elastic - exact), 1e-4 * std::abs(exact));

  // Steps of 0.03 / |lambda|, for which the method's own error is 0.02 % of |lambda|.
  const double step = 0.03 / std::abs(exact);
  const auto method = oscillation(
      Eigen::VectorXcd(small::sdirk_step(rigid_wheel(c), step).eigenvalues().array().log() / step));
  EXPECT_LT(std::abs(method - exact), 2e-4 * std::abs(exact));
  std::vector<double> angles = swivel_angles(step);
  ASSERT_EQ(angles.size(), kCount + 1u);
  angles.erase(angles.begin(), angles.begin() + kSettled);  // the push is over
  const auto found = oscillation(small::exponents(angles, step, 3));
  // 1e-5 of |lambda| for terms of third order in theta, as in flutter_test.
  const double rest = std::abs(elastic - exact) + 1e-5 * std::abs(exact);
  EXPECT_NEAR(found.real(), exact.real(), std::abs(method.real() - exact.real()) + rest);
  EXPECT_NEAR(found.imag(), exact.imag(), std::abs(method.imag() - exact.imag()) + rest);
}

INSTANTIATE_TEST_SUITE_P(MasslessPivot, Shimmy,
                         testing::Values(Case{1, 0.05, 0.03, 0.5, 2e4, 1, 1e-3},
                                         Case{1, 0.05, 0.03, 0.9, 2e4, 1, 1e-3},
                                         Case{1, 0.05, 0.03, 1, 2e4, 1, 1e-3},
                                         Case{1, 0.05, 0.03, 3, 2e4, 1, 1e-3},
                                         Case{1, 0.05, 0.03, 1.1, 5e3, 2, 1e-3},
                                         Case{1, 0.05, 0.03, 0.8, 5e4, 0.5, 1e-3},
                                         Case{0.5, 0.034, 0.02, 0.7, 1e4, 1.5, 1e-3},
                                         Case{0.5, 0.034, 0.02, 1.5, 3e4, 1.5, 1e-3}));

INSTANTIATE_TEST_SUITE_P(HeavyPivot, Shimmy,
                         testing::Values(Case{1, 0.05, 0.03, 0.9, 2e4, 1, 2},
                                         Case{1, 0.05, 0.03, 1, 2e4, 1, 5},
                                         Case{1, 0.05, 0.03, 1.2, 2e4, 2, 5},
                                         Case{0.6, 0.04, 0.015, 3, 4e4, 1, 20},
                                         Case{0.6, 0.04, 0.015, 0.5, 4e4, 1, 20}));

}  // namespace
}  // namespace gurney
