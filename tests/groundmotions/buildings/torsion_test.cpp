#include "groundmotions/buildings/torsion.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "engine/base/linear_algebra.h"
#include "engine/base/units.h"
#include "groundmotions/buildings/building.h"
#include "groundmotions/buildings/floor_record.h"
#include "groundmotions/buildings/modal_building.h"
#include "groundmotions/synthetic/clough_penzien.h"
#include "tests/groundmotions/buildings/matrix_exponential.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;

/// One storey of unit mass with omega_x, omega_y [rad/s].
TorsionalBuilding one_storey(double omega_x, double omega_y, const Vector2& eccentricity,
                             double gyration, double ratio) {
  TorsionalBuilding building{.mass = Eigen::VectorXd::Ones(1)};
  building.stiffness = {Eigen::MatrixXd::Constant(1, 1, omega_x * omega_x),
                        Eigen::MatrixXd::Constant(1, 1, omega_y * omega_y)};
  building.eccentricity = eccentricity;
  building.gyration = gyration;
  building.frequency_ratio = ratio;
  return building;
}

TorsionalBuilding three_storeys(double eccentricity) {
  TorsionalBuilding building{.mass = Eigen::Vector3d(3, 2, 1)};
  building.stiffness = {shear_stiffness(Eigen::Vector3d(900, 700, 400)),
                        shear_stiffness(Eigen::Vector3d(1200, 800, 500))};
  building.eccentricity.resize(2, 3);
  building.eccentricity << 1, 2, 1.5, -0.5, 0, 2;
  building.eccentricity *= eccentricity;
  building.gyration = 8;
  building.frequency_ratio = 1.2;
  return building;
}

// Chopra, Dynamics of Structures, section 9.6 and 13.3: with e along x alone, u_x stays by itself and
// u_y is coupled with theta. About the centre of mass, per unit mass, with w = omega_y,
//   [w^2  -w^2 e; -w^2 e  w^2 e^2 + Omega^2 r^2 w_x^2],  diag(1, r^2):
//   lambda^2 - lambda (w^2 (1 + e^2 / r^2) + Omega^2 w_x^2) + w^2 Omega^2 w_x^2 = 0.
TEST(Torsion, OneStoreyWithOneEccentricityHasTheTwoCoupledFrequencies) {
  const double wx = 9, wy = 11, e = 2.5, r = 7, ratio = 1.1;
  const auto modes = torsion_modes(one_storey(wx, wy, {e, 0}, r, ratio));
  const double sum = wy * wy * (1 + e * e / (r * r)) + std::pow(ratio * wx, 2);
  const double product = std::pow(wy * ratio * wx, 2);
  const double root = std::sqrt(sum * sum / 4 - product);
  ASSERT_EQ(modes.size(), 3U);
  std::array<double, 3> expected = {std::sqrt(sum / 2 - root), wx, std::sqrt(sum / 2 + root)};
  std::ranges::sort(expected);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(modes[i].omega, expected[i], 1e-12 * expected[i]);
}

TEST(Torsion, EffectiveMassesAddUpAndAFollowingGroundDoesNotTwist) {
  const TorsionalBuilding building = three_storeys(1);
  const auto modes = torsion_modes(building);
  Eigen::Matrix2d masses = Eigen::Matrix2d::Zero();
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(3, 4), turned = moved;
  for (const TorsionMode& mode : modes) {
    masses += mode.participation * mode.participation.transpose();
    moved += mode.shape * mode.participation.x();
    turned += mode.shape * mode.participation.y();
  }
  const double whole = building.mass.sum();
  EXPECT_LT((masses - whole * Eigen::Matrix2d::Identity()).norm(), 1e-12 * whole);
  for (Eigen::Index floor = 1; floor < 4; ++floor) {
    EXPECT_LT((moved.col(floor) - Vector3(1, 0, 0)).norm(), 1e-12);
    EXPECT_LT((turned.col(floor) - Vector3(0, 1, 0)).norm(), 1e-12);
  }
}

// About the centres of mass, where the mass is diagonal, and with modal damping from those coordinates'
// own modes: another form of the same equations, solved by the matrix exponential.
TEST(Torsion, PlacesFollowTheMatrixExponentialAboutTheCentresOfMass) {
  constexpr double kStep = 0.02, kDamping = 0.04;
  const TorsionalBuilding b = three_storeys(1);
  const Eigen::Index n = 3;
  Eigen::MatrixXd to_axis = Eigen::MatrixXd::Identity(9, 9);  // from centres of mass to the axis
  for (Eigen::Index i = 0; i < n; ++i) {
    to_axis(i, 6 + i) = b.eccentricity(1, i);
    to_axis(3 + i, 6 + i) = -b.eccentricity(0, i);
  }
  Eigen::MatrixXd at_axis = Eigen::MatrixXd::Zero(9, 9);
  at_axis.block(0, 0, 3, 3) = b.stiffness[0];
  at_axis.block(3, 3, 3, 3) = b.stiffness[1];
  at_axis.block(6, 6, 3, 3) = std::pow(b.frequency_ratio * b.gyration, 2) * b.stiffness[0];
  Eigen::VectorXd mass(9);
  mass << b.mass, b.mass, b.gyration * b.gyration * b.mass;
  const Eigen::MatrixXd stiffness = to_axis.transpose() * at_axis * to_axis;
  const NaturalModes natural = natural_modes(stiffness, Eigen::MatrixXd(mass.asDiagonal()));
  const Eigen::MatrixXd momenta = mass.asDiagonal() * natural.shapes;
  const Eigen::VectorXd rates = 2 * kDamping * natural.squared_frequencies.cwiseSqrt();
  const Eigen::MatrixXd damping = momenta * rates.asDiagonal() * momenta.transpose();

  // State: displacements, velocities, ground acceleration and its slope in the step.
  Eigen::MatrixXd rate = Eigen::MatrixXd::Zero(22, 22);
  rate.block(0, 9, 9, 9).setIdentity();
  const Eigen::MatrixXd inverse = mass.cwiseInverse().asDiagonal();
  rate.block(9, 0, 9, 9) = -inverse * stiffness;
  rate.block(9, 9, 9, 9) = -inverse * damping;
  for (Eigen::Index i = 0; i < n; ++i) rate(9 + i, 18) = rate(12 + i, 19) = -1;
  rate(18, 20) = rate(19, 21) = 1;
  const Eigen::MatrixXd advance = matrix_exponential(rate * kStep);

  auto modes = torsion_modes(b);
  for (TorsionMode& mode : modes) mode.damping = kDamping;
  const Eigen::Index floor = 2;
  const Vector2 place(6, -4);
  TorsionResponse response(modes, floor, place, kStep);
  Eigen::VectorXd state = Eigen::VectorXd::Zero(22);
  const auto ground = [](int i) {
    return Vector2(std::sin(0.13 * i) + 0.3 * std::cos(0.7 * i), std::cos(0.31 * i));
  };
  double peak = 0, error = 0, peak_yaw = 0, error_of_yaw = 0;
  for (int i = 0; i < 500; ++i) {
    const Vector2 a = ground(i), next = ground(i + 1);
    state.segment(18, 2) = a;
    state.segment(20, 2) = (next - a) / kStep;
    state = advance * state;
    response.step(a, next);
    const Eigen::VectorXd relative = (rate * state).segment(9, 9);
    const Eigen::Index k = floor - 1;
    const Vector2 arm = place - b.eccentricity.col(k);  // from the centre of mass
    const double twist = relative[6 + k];
    const Vector3 expected(next.x() + relative[k] - twist * arm.y(),
                           next.y() + relative[3 + k] + twist * arm.x(), twist);
    peak = std::max(peak, expected.norm());
    error = std::max(error, (response.acceleration(next) - expected).norm());
    peak_yaw = std::max(peak_yaw, std::abs(state[6 + k]));
    error_of_yaw = std::max(error_of_yaw, std::abs(response.yaw() - state[6 + k]));
  }
  EXPECT_GT(peak_yaw, 5e-4);
  EXPECT_LT(error, 1e-10 * peak);
  EXPECT_LT(error_of_yaw, 1e-10 * peak_yaw);
}

// Steady state of the system of the first test under a cos(w t) along y: the complex amplitudes of u_y
// and theta solve (-w^2 M + i w C + K) U = -M 1 a, with 2 zeta omega of the coupled modes.
TEST(Torsion, SteadyStateIsTheTransferFunction) {
  constexpr double kDamping = 0.05, kStep = 0.001;
  const double wy = 11, e = 2.5, r = 7, ratio = 1.1, wx = 9, w = 8;
  Eigen::Matrix2d mass = Vector2(1, r * r).asDiagonal(), stiffness;
  stiffness << wy * wy, -wy * wy * e, -wy * wy * e, wy * wy * e * e + std::pow(ratio * r * wx, 2);
  const NaturalModes natural = natural_modes(stiffness, mass);
  const Eigen::Matrix2d momenta = mass * natural.shapes;
  const Eigen::Vector2d rates = 2 * kDamping * natural.squared_frequencies.cwiseSqrt();
  const Eigen::Matrix2d damping = momenta * rates.asDiagonal() * momenta.transpose();
  const std::complex<double> i(0, 1);
  const Eigen::Matrix2cd dynamic = -w * w * mass + i * w * damping + stiffness;
  const Eigen::Vector2cd relative = dynamic.partialPivLu().solve(Eigen::Vector2cd(-1, 0));
  const Vector2 place(5, 3);
  const std::complex<double> along_y = 1.0 - w * w * (relative[0] + relative[1] * (place.x() - e)),
                             along_x = w * w * relative[1] * place.y();

  auto modes = torsion_modes(one_storey(wx, wy, {e, 0}, r, ratio));
  for (TorsionMode& mode : modes) mode.damping = kDamping;
  TorsionResponse response(modes, 1, place, kStep);
  const auto ground = [&](int k) { return Vector2(0, std::cos(w * kStep * k)); };
  Vector2 peak(0, 0);
  double yaw = 0;
  for (int k = 0; k < 40000; ++k) {  // exp(-0.05 * 9 * 30) = 1e-6 of the start is left at 30 s
    response.step(ground(k), ground(k + 1));
    if (k < 30000) continue;
    peak = peak.cwiseMax(response.acceleration(ground(k + 1)).head<2>().cwiseAbs());
    yaw = std::max(yaw, std::abs(response.yaw()));
  }
  // The input's corners and the sampling of its peaks: (w h)^2 / 8 = 8e-6 each.
  EXPECT_NEAR(peak.x(), std::abs(along_x), 2e-5 * std::abs(along_x));
  EXPECT_NEAR(peak.y(), std::abs(along_y), 2e-5 * std::abs(along_y));
  EXPECT_NEAR(yaw, std::abs(relative[1]), 2e-5 * std::abs(relative[1]));
}

Record shaken() { return synthetic_record(shipped_synthetic_motion()); }

Building building_of(const TorsionalBuilding& twisting) {
  Building building{"House", 3, {}, {}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    building.axes[i] = modes_of(twisting.mass, twisting.stiffness[i]);
    set_damping(building.axes[i], 0.05);
  }
  building.torsion = torsion_modes(twisting);
  for (TorsionMode& mode : building.torsion) mode.damping = 0.05;
  return building;
}

TEST(Torsion, WithoutEccentricityItIsTheBuildingThatDoesNotTwist) {
  const Building twisting = building_of(three_storeys(0));
  Building straight = twisting;
  straight.torsion.clear();
  const Record a = floor_record(shaken(), twisting, 2, {7, -3}),
               b = floor_record(shaken(), straight, 2);
  ASSERT_TRUE(a.rotation);
  EXPECT_LT(a.rotation->angle.cwiseAbs().maxCoeff(), 1e-15);
  for (const Direction direction : kDirections) {
    ASSERT_EQ(a.time_step(), b.time_step());
    const Eigen::VectorXd &twisted = a[direction]->acceleration,
                          &level = b[direction]->acceleration;
    const Eigen::Index samples = std::min(twisted.size(), level.size());
    EXPECT_LT((twisted.head(samples) - level.head(samples)).cwiseAbs().maxCoeff(),
              1e-12 * level.cwiseAbs().maxCoeff());
  }
}

// A record with one horizontal is one whose other horizontal is zero.
TEST(Torsion, AGroundAlongOneAxisMovesTheFloorAlongBoth) {
  const Building building = building_of(three_storeys(1));
  for (const Direction missing : {Direction::kH1, Direction::kH2}) {
    Record zero = shaken();
    auto& component = zero.components[static_cast<std::size_t>(missing)];
    component->acceleration.setZero();
    Record absent = zero;
    absent.components[static_cast<std::size_t>(missing)].reset();
    const Record expected = floor_record(zero, building, 3, {6, 2}),
                 found = floor_record(absent, building, 3, {6, 2});
    ASSERT_TRUE(found[missing]);
    EXPECT_GT(found[missing]->acceleration.cwiseAbs().maxCoeff(), 0);
    EXPECT_EQ(found[missing]->acceleration, expected[missing]->acceleration);
    EXPECT_EQ(found[missing]->time_step, expected[missing]->time_step);
    EXPECT_FALSE(floor_record(absent, building, 0)[missing]) << "the base moves as the ground";
  }
}

// Mirrored about the plane of h1, the building twists the other way round.
TEST(Torsion, AMirroredBuildingMovesInMirrorImage) {
  TorsionalBuilding b = three_storeys(1);
  const Building one = building_of(b);
  b.eccentricity.row(1) *= -1;
  const Building other = building_of(b);
  Record ground = shaken();
  const Record a = floor_record(ground, one, 3, {6, 2});
  ground.components[1]->acceleration *= -1;
  const Record c = floor_record(ground, other, 3, {6, -2});
  const auto differ = [](const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
    return (x - y).cwiseAbs().maxCoeff() / x.cwiseAbs().maxCoeff();
  };
  EXPECT_LT(differ(a.components[0]->acceleration, c.components[0]->acceleration), 1e-11);
  EXPECT_LT(differ(a.components[1]->acceleration, -c.components[1]->acceleration), 1e-11);
  EXPECT_LT(differ(a.rotation->angle.row(2), -c.rotation->angle.row(2)), 1e-11);
  EXPECT_LT(differ(a.rotation->acceleration.row(2), -c.rotation->acceleration.row(2)), 1e-11);
}

Vector2 peaks_at(const std::string& building, const Vector2& place) {
  const Building shipped = building_from_file(std::string(GURNEY_SOURCE_DIR) +
                                              "/groundmotions/buildings/" + building + ".toml");
  const Record roof = floor_record(shaken(), shipped, 4, place);
  EXPECT_GT(roof.rotation->angle.row(2).cwiseAbs().maxCoeff(), 1e-3) << building;
  return Vector2(roof.components[0]->acceleration.cwiseAbs().maxCoeff(),
                 roof.components[1]->acceleration.cwiseAbs().maxCoeff()) /
         kStandardGravity;
}

// The numbers of docs/theory/buildings.md, to their last digit.
TEST(Torsion, TheShippedBuildingHasThePeaksOfThePage) {
  const auto expect = [](const Vector2& peaks, double h1, double h2) {
    EXPECT_NEAR(peaks.x(), h1, 0.005);
    EXPECT_NEAR(peaks.y(), h2, 0.005);
  };
  expect(peaks_at("twisting_hospital", {0, 0}), 0.91, 0.69);
  expect(peaks_at("twisting_hospital", {20, 10}), 0.93, 1.04);
  expect(peaks_at("twisting_hospital", {-20, -10}), 1.05, 0.89);
}

// Storeys at the limit of yield: more than the elastic roof, whose damping is 5 % in place of 3 %.
TEST(Torsion, TheShippedBuildingAlsoYields) {
  const Vector2 elastic = peaks_at("twisting_hospital", {-20, -10}),
                yielding = peaks_at("yielding_twisting_hospital", {-20, -10});
  EXPECT_GT(yielding.x(), elastic.x());
  EXPECT_LT(yielding.x(), 2 * elastic.x());
}

// A rigid floor: at two places the accelerations differ by theta'' x r.
TEST(Torsion, PlacesOfAFloorDifferByItsYaw) {
  const Building building = building_of(three_storeys(1));
  const Record near = floor_record(shaken(), building, 3),
               far = floor_record(shaken(), building, 3, {10, 4});
  const Eigen::VectorXd yaw = near.rotation->acceleration.row(2);
  const Eigen::Index samples = std::min(near.samples(), far.samples());
  const auto difference = [&](std::size_t i) -> Eigen::VectorXd {
    return far.components[i]->acceleration.head(samples) -
           near.components[i]->acceleration.head(samples);
  };
  EXPECT_LT((difference(0) + 4 * yaw.head(samples)).cwiseAbs().maxCoeff(),
            1e-12 * yaw.cwiseAbs().maxCoeff() * 10);
  EXPECT_LT((difference(1) - 10 * yaw.head(samples)).cwiseAbs().maxCoeff(),
            1e-12 * yaw.cwiseAbs().maxCoeff() * 10);
}

}  // namespace
}  // namespace gurney::groundmotions
