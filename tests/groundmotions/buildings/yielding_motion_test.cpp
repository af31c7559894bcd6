#include "groundmotions/buildings/yielding_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "groundmotions/buildings/modal_building.h"
#include "groundmotions/buildings/torsion.h"
#include "tests/support/small_steps_of_pinching.h"

namespace gurney::groundmotions {
namespace {

using std::numbers::pi;

constexpr double kEnd = 8;  // [s]

/// A smooth motion in two directions that begins and ends at rest [m/s2].
Vector2 shake(double t) {
  const double envelope = t < kEnd ? std::pow(std::sin(pi * t / kEnd), 2) : 0;
  return envelope * Vector2(4 * std::sin(3 * t), 3 * std::sin(4.3 * t + 1));
}

/// Equal storeys of this period in both directions.
YieldingStoreys storeys_of(int count, double period, double yield_drift, double hardening,
                           double damping) {
  YieldingStoreys storeys;
  storeys.mass = Eigen::VectorXd::Ones(count);
  const double omega =
      modes_of(storeys.mass, shear_stiffness(Eigen::VectorXd::Ones(count))).front().omega;
  storeys.stiffness.fill(Eigen::VectorXd::Constant(count, std::pow(2 * pi / period / omega, 2)));
  storeys.damping.fill(Eigen::VectorXd::Constant(count, damping));
  storeys.yield_drift = Eigen::VectorXd::Constant(count, yield_drift);
  storeys.hardening = hardening;
  return storeys;
}

/// Largest error of the roof's acceleration along h1 against the exact steps of the modes.
double error_against_modes(double h) {
  YieldingStoreys storeys = storeys_of(3, 0.5, 1e9, 0.1, 0.05);
  storeys.mass *= 2;  // with the stiffness: the same modes
  for (Eigen::VectorXd& stiffness : storeys.stiffness) stiffness *= 2;
  YieldingMotion motion(storeys, h);
  ModalAxis axis = modes_of(Eigen::Vector3d::Ones(), shear_stiffness(Eigen::Vector3d::Ones()));
  scale_to_period(axis, 0.5);
  set_damping(axis, 0.05);
  ModalResponse modes(axis, 3, h);
  double error = 0;
  for (int i = 0; i * h < kEnd; ++i) {
    const Vector2 a = shake(i * h), b = shake((i + 1) * h);
    motion.step(a, b);
    error = std::max(error, std::abs(modes.step(a.x(), b.x()) - motion.floor_acceleration(3).x()));
  }
  return error;
}

// Second order: halving the step leaves a quarter, within a tenth of that for the next order.
TEST(YieldingMotion, BelowYieldIsTheSumOfModesInSecondOrder) {
  const double coarse = error_against_modes(2e-3), fine = error_against_modes(1e-3);
  EXPECT_NEAR(coarse / fine, 4, 0.4);
  // Phase (omega h)^2 / 12 of omega t late: 12.6 rad/s for 8 s, 1.3e-3 of 4 m/s2 amplified some threefold.
  EXPECT_LT(fine, 0.02);
}

/// Bilinear shear along one line by another method: symplectic steps of 10 us, the plastic part of the
/// drift returned to the yield surface after each.
std::vector<double> drift_along_a_line(const YieldingStoreys& storeys, double period, double h) {
  constexpr double kStep = 1e-5;
  const double omega = 2 * pi / period, alpha = storeys.hardening, d_y = storeys.yield_drift[0];
  double u = 0, v = 0, plastic = 0;
  std::vector<double> result;
  const auto every = static_cast<long>(std::lround(h / kStep));
  for (long i = 0; static_cast<double>(i) * kStep < kEnd + 2; ++i) {
    if (i % every == 0) result.push_back(u);
    const double force = alpha * u + (1 - alpha) * (u - plastic);
    v -= kStep *
         (shake(static_cast<double>(i) * kStep).x() + 2 * 0.05 * omega * v + omega * omega * force);
    u += kStep * v;
    plastic += (u - plastic) - std::clamp(u - plastic, -d_y, d_y);
  }
  return result;
}

double error_along_a_line(double h) {
  const YieldingStoreys storeys = storeys_of(1, 0.6, 0.01, 0.05, 0.05);
  YieldingMotion motion(storeys, h);
  const std::vector<double> expected = drift_along_a_line(storeys, 0.6, h);
  double error = 0, ductility = 0;
  for (std::size_t i = 0; i + 1 < expected.size(); ++i) {
    const double t = static_cast<double>(i) * h;
    motion.step({shake(t).x(), 0}, {shake(t + h).x(), 0});
    const double drift = motion.drift()(0, 0);
    error = std::max(error, std::abs(drift - expected[i + 1]));
    ductility = std::max(ductility, std::abs(drift) / storeys.yield_drift[0]);
  }
  EXPECT_GT(ductility, 3) << "the storey must yield";
  return error;
}

// The steps of 10 us miss a drift of 0.05 m by omega kStep / 2 = 5e-5 of it where motion reverses, 3e-6 m,
// and add that at some ten reversals. The midpoint rule misses (omega h)^2 / 12 of a cycle's change.
TEST(YieldingMotion, FollowsABilinearStoreySolvedInAnotherWay) {
  EXPECT_LT(error_along_a_line(1e-3), 3e-5 + 10 * 0.05 * std::pow(10.5e-3, 2) / 12);
  EXPECT_LT(error_along_a_line(2.5e-4), 3e-5 + 10 * 0.05 * std::pow(2.6e-3, 2) / 12);
}

// alpha K d + (1 - alpha) K d_y = m a at rest. Ground that accelerates ever slower leaves no swing: the
// rate of 0.03 m/s3 makes one of rate / omega^3 with the softened frequency, 4 rad/s: 5e-4 m.
TEST(YieldingMotion, AConstantAccelerationLeavesTheDriftOfTheBackbone) {
  const YieldingStoreys storeys = storeys_of(2, 0.6, 0.01, 0.2, 0.3);
  YieldingMotion motion(storeys, 5e-3);
  const double strength = storeys.stiffness[0][0] * 0.01, push = 1.5 * strength / 2;
  const double stop = 60, ramp = push / stop;
  const Vector2 along(0.6, 0.8);
  for (int i = 0; i < 16000; ++i) {
    const auto ground = [&](int k) { return Vector2(ramp * std::min(5e-3 * k, stop) * along); };
    motion.step(ground(i), ground(i + 1));
  }
  // The lower storey carries both masses, the upper one half of that, which is below its strength.
  const double lower = (2 * push - 0.8 * strength) / (0.2 * storeys.stiffness[0][0]);
  const double upper = push / storeys.stiffness[0][0];
  EXPECT_NEAR(motion.drift().col(0).head<2>().dot(along), -lower, 5e-4);
  EXPECT_NEAR(motion.drift().col(1).head<2>().dot(along), -upper, 5e-4);
  // Yield is the same in all directions: nothing moves across.
  EXPECT_NEAR(motion.drift()(0, 0) * 0.8, motion.drift()(1, 0) * 0.6, 1e-12);
  EXPECT_GT(lower, 0.02) << "yields by more than twice";
}

TEST(YieldingMotion, EnergiesClose) {
  YieldingMotion motion(storeys_of(4, 0.6, 0.006, 0.03, 0.05), 2e-3);
  double input = 0;
  for (int i = 0; i < 6000; ++i) {
    motion.step(shake(2e-3 * i), shake(2e-3 * (i + 1)));
    input = std::max(input, motion.energy().input);
    ASSERT_LT(std::abs(motion.energy().closure()), 1e-10 * std::max(input, 1.0));
  }
  const StoreyEnergy& energy = motion.energy();
  EXPECT_GT(energy.hysteresis, 0.3 * energy.input) << "most of the input is dissipated by yielding";
  EXPECT_LT(energy.kinetic, 1e-3 * energy.input) << "it rests";
}

// A circle about the origin of the yield surface: a motion turned in plan turns the response.
TEST(YieldingMotion, TurnsWithTheGround) {
  YieldingStoreys storeys = storeys_of(2, 0.6, 0.006, 0.03, 0.05);
  storeys.mass << 1.5, 0.7;
  YieldingMotion straight(storeys, 2e-3), turned(storeys, 2e-3);
  Eigen::Matrix3d turn;
  turn << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
  for (int i = 0; i < 4000; ++i) {
    const Vector2 a = shake(2e-3 * i), b = shake(2e-3 * (i + 1));
    straight.step(a, b);
    turned.step(turn.topLeftCorner<2, 2>() * a, turn.topLeftCorner<2, 2>() * b);
    // Solves end at 1e-12 of the velocity of 0.5 m/s, 4000 times 1e-15 m.
    ASSERT_LT((turned.drift() - turn * straight.drift()).cwiseAbs().maxCoeff(), 1e-11);
    // Times omega^2 of the upper mode, 20^2 here, and as much for what damping adds.
    ASSERT_LT((turned.floor_acceleration(1, {0, 0}) - turn * straight.floor_acceleration(1, {0, 0}))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-8);
  }
  EXPECT_GT(straight.drift().col(0).norm(), 1e-4) << "a residual drift";
}

/// Largest error of the drift of one pinched storey along h1 against symplectic steps of 10 us with increments of
/// the rule, over the largest drift; the other direction moves too, and yields by itself.
double error_of_pinched_storey(double h) {
  constexpr double kStep = 1e-5;
  YieldingStoreys storeys = storeys_of(1, 0.6, 0.01, 0.05, 0.05);
  storeys.pinching = Pinching{0.8, 0.25};
  YieldingMotion motion(storeys, h);
  SmallStepsOfPinching rule(0.05, 0.8, 0.25);
  const double omega = 2 * pi / 0.6, d_y = 0.01;
  double v = 0, error = 0, peak = 0;
  const long every = std::lround(h / kStep);
  for (long i = 0; static_cast<double>(i) * kStep < kEnd + 2; ++i) {
    const double t = static_cast<double>(i) * kStep;
    if (i % every == 0) {
      error = std::max(error, std::abs(motion.drift()(0, 0) - d_y * rule.drift));
      peak = std::max(peak, std::abs(motion.drift()(0, 0)));
      motion.step(shake(t), shake(t + h));
    }
    v -= kStep * (shake(t).x() + 2 * 0.05 * omega * v + omega * omega * d_y * rule.force);
    rule.go(kStep * v / d_y);
  }
  EXPECT_GT(peak, 3 * d_y) << "the storey must yield";
  return error / peak;
}

// As of the bilinear storey the steps of 10 us miss omega kStep / 2 = 5e-5 of the drift at each of some ten
// reversals, and the midpoint rule (omega h)^2 / 12 of each: 3.7e-5 at 2 ms, 2e-6 at 0.5 ms.
TEST(YieldingMotion, FollowsAPinchedStoreySolvedInAnotherWay) {
  EXPECT_LT(error_of_pinched_storey(2e-3), 10 * (5e-5 + 3.7e-5));
  EXPECT_LT(error_of_pinched_storey(5e-4), 10 * (5e-5 + 2e-6));
}

TEST(YieldingMotion, EnergiesOfPinchedStoreysClose) {
  YieldingStoreys pinched = storeys_of(4, 0.6, 0.006, 0.03, 0.05);
  const YieldingStoreys bilinear = pinched;
  pinched.pinching = Pinching{0.8, 0.25};
  YieldingMotion motion(pinched, 2e-3), fat(bilinear, 2e-3);
  double input = 0, lost = 0;
  for (int i = 0; i < 6000; ++i) {
    motion.step(shake(2e-3 * i), shake(2e-3 * (i + 1)));
    fat.step(shake(2e-3 * i), shake(2e-3 * (i + 1)));
    input = std::max(input, motion.energy().input);
    ASSERT_LT(std::abs(motion.energy().closure()), 1e-10 * std::max(input, 1.0));
    ASSERT_GE(motion.energy().hysteresis, lost - 1e-12) << "what is lost does not come back";
    lost = motion.energy().hysteresis;
  }
  EXPECT_GT(lost, 0.1 * motion.energy().input);
  EXPECT_LT(lost / motion.energy().input, fat.energy().hysteresis / fat.energy().input)
      << "loops are thinner";
}

/// Storeys of columns at (+-a, +-b), a building that is stiffer along h2 and whose masses lie off its axis.
YieldingStoreys twisting_storeys(int count, double yield_drift, double eccentricity) {
  YieldingStoreys storeys = storeys_of(count, 0.6, yield_drift, 0.04, 0.05);
  storeys.stiffness[1] *= 1.5;
  YieldingTwist& twist = storeys.twist.emplace();
  twist.eccentricity = Vector2(2 * eccentricity, eccentricity).replicate(1, count);
  twist.gyration = 12;
  twist.columns = Vector2(9, 5).replicate(1, count);
  twist.damping = Eigen::VectorXd::Constant(3 * count, 0.05);
  return storeys;
}

/// Modes of these storeys where nothing yields: K_t = K_x b^2 + K_y a^2 = Omega^2 r^2 K_x.
std::vector<TorsionMode> elastic_modes(const YieldingStoreys& storeys) {
  const YieldingTwist& twist = *storeys.twist;
  TorsionalBuilding building{
      storeys.mass,
      {shear_stiffness(storeys.stiffness[0]), shear_stiffness(storeys.stiffness[1])},
      twist.eccentricity,
      twist.gyration,
      std::sqrt(5 * 5 + 1.5 * 9 * 9) / twist.gyration};
  std::vector<TorsionMode> modes = torsion_modes(building);
  for (TorsionMode& mode : modes) mode.damping = 0.05;
  return modes;
}

/// Errors of the accelerations at a place and of the yaw and its acceleration.
Eigen::Vector4d error_against_twisting_modes(double h) {
  const YieldingStoreys storeys = twisting_storeys(3, 1e9, 1);
  const Vector2 place(11, -7);
  YieldingMotion motion(storeys, h);
  TorsionResponse modes(elastic_modes(storeys), 3, place, h);
  Eigen::Vector4d error = Eigen::Vector4d::Zero();
  for (int i = 0; i * h < kEnd; ++i) {
    const Vector2 a = shake(i * h), b = shake((i + 1) * h);
    motion.step(a, b);
    modes.step(a, b);
    const Vector3 difference = motion.floor_acceleration(3, place) - modes.acceleration(b);
    error.head<3>() = error.head<3>().cwiseMax(difference.cwiseAbs());
    error[3] = std::max(error[3], std::abs(motion.yaw(3) - modes.yaw()));
  }
  return error;
}

// As without torsion, for the motions of a place far from the axis.
TEST(TwistingYield, BelowYieldIsTheSumOfCoupledModesInSecondOrder) {
  const Eigen::Vector4d coarse = error_against_twisting_modes(2e-3),
                        fine = error_against_twisting_modes(1e-3);
  for (Eigen::Index i = 0; i < 4; ++i) EXPECT_NEAR(coarse[i] / fine[i], 4, 0.4) << i;
}

/// One storey about its centre of mass, columns of bilinear springs that follow radial return, symplectic
/// steps: another method, other coordinates. The drift of the axis along h1 and h2, and the yaw, each `h`.
std::vector<Vector3> storey_with_radial_return(const YieldingStoreys& storeys, double h) {
  constexpr double kStep = 1e-5;
  const YieldingTwist& twist = *storeys.twist;
  const Vector2 e = twist.eccentricity.col(0);
  const double alpha = storeys.hardening, d_y = storeys.yield_drift[0], r = twist.gyration;
  const double a = twist.columns(0, 0), b = twist.columns(1, 0);
  const std::array<Vector2, 4> places = {
      {Vector2(a, b) - e, Vector2(-a, b) - e, Vector2(-a, -b) - e, Vector2(a, -b) - e}};
  const Vector2 k(storeys.stiffness[0][0] / 4, storeys.stiffness[1][0] / 4);
  // Modal damping in the coordinates of the centre of mass: u_x, u_y, r theta.
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  for (const Vector2& place : places) {
    Eigen::Matrix<double, 2, 3> moves;
    moves << 1, 0, -place.y() / r, 0, 1, place.x() / r;
    stiffness += moves.transpose() * k.asDiagonal() * moves;
  }
  const NaturalModes natural = natural_modes(stiffness, Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d damping =
      natural.shapes *
      (2 * twist.damping.array() * natural.squared_frequencies.array().sqrt())
          .matrix()
          .asDiagonal() *
      natural.shapes.transpose();
  Vector3 u = Vector3::Zero(), v = Vector3::Zero();
  std::array<Vector2, 4> plastic;
  plastic.fill(Vector2::Zero());
  std::vector<Vector3> result;
  const auto every = static_cast<long>(std::lround(h / kStep));
  for (long i = 0; static_cast<double>(i) * kStep < kEnd + 2; ++i) {
    const double yaw = u.z() / r;
    if (i % every == 0) result.emplace_back(u.x() + yaw * e.y(), u.y() - yaw * e.x(), yaw);
    Vector3 push = -damping * v;
    for (std::size_t c = 0; c < 4; ++c) {
      const Vector2& place = places[c];
      const Vector2 d(u.x() - yaw * place.y(), u.y() + yaw * place.x());
      Vector2 spring = d - plastic[c];
      if (spring.norm() > d_y) spring *= d_y / spring.norm();
      plastic[c] = d - spring;
      const Vector2 shear = k.cwiseProduct(alpha * d + (1 - alpha) * spring);
      push -= Vector3(shear.x(), shear.y(), (place.x() * shear.y() - place.y() * shear.x()) / r);
    }
    const Vector2 ground = shake(static_cast<double>(i) * kStep);
    v += kStep * (push - Vector3(ground.x(), ground.y(), 0));
    u += kStep * v;
  }
  return result;
}

Vector3 error_of_twisting_storey(double h) {
  const YieldingStoreys storeys = twisting_storeys(1, 0.01, 1);
  YieldingMotion motion(storeys, h);
  const std::vector<Vector3> expected = storey_with_radial_return(storeys, h);
  Vector3 error = Vector3::Zero();
  double ductility = 0;
  for (std::size_t i = 0; i + 1 < expected.size(); ++i) {
    const double t = static_cast<double>(i) * h;
    motion.step(shake(t), shake(t + h));
    error = error.cwiseMax((motion.drift().col(0) - expected[i + 1]).cwiseAbs());
    ductility = std::max(ductility, motion.column_drift()[0] / 0.01);
  }
  EXPECT_GT(ductility, 3) << "a column must yield";
  EXPECT_GT(std::abs(expected.back().z()), 1e-5) << "and keep a twist";
  return error;
}

// The bounds of FollowsABilinearStoreySolvedInAnotherWay; the yaw has those of a drift 12 m away.
TEST(TwistingYield, FollowsColumnsWithRadialReturnAboutTheCentreOfMass) {
  for (const double h : {1e-3, 2.5e-4}) {
    const Vector3 error = error_of_twisting_storey(h);
    const double bound = 3e-5 + 10 * 0.05 * std::pow(10.5 * h, 2) / 12;
    EXPECT_LT(error.x(), bound);
    EXPECT_LT(error.y(), bound);
    EXPECT_LT(error.z(), bound / 12);
  }
}

// Columns of a floor that does not turn drift alike: together they are the storey.
TEST(TwistingYield, WithoutEccentricityColumnsAreTheStorey) {
  const YieldingStoreys columns = twisting_storeys(3, 0.006, 0);
  YieldingStoreys one = columns;
  one.twist.reset();
  YieldingMotion a(columns, 2e-3), b(one, 2e-3);
  for (int i = 0; i < 4000; ++i) {
    a.step(shake(2e-3 * i), shake(2e-3 * (i + 1)));
    b.step(shake(2e-3 * i), shake(2e-3 * (i + 1)));
    ASSERT_LT((a.drift() - b.drift()).cwiseAbs().maxCoeff(), 1e-11);  // as TurnsWithTheGround
  }
  EXPECT_GT(b.column_drift().maxCoeff(), 1e-4) << "a residual drift";
}

TEST(TwistingYield, EnergiesCloseAndTheMirroredBuildingTwistsTheOtherWay) {
  YieldingStoreys storeys = twisting_storeys(4, 0.006, 1);
  YieldingMotion motion(storeys, 2e-3);
  storeys.twist->eccentricity.row(1) *= -1;
  YieldingMotion mirrored(storeys, 2e-3);
  const Vector3 mirror(1, -1, -1);
  double input = 0, yaw = 0;
  for (int i = 0; i < 6000; ++i) {
    const Vector2 a = shake(2e-3 * i), b = shake(2e-3 * (i + 1));
    motion.step(a, b);
    mirrored.step({a.x(), -a.y()}, {b.x(), -b.y()});
    input = std::max(input, motion.energy().input);
    ASSERT_LT(std::abs(motion.energy().closure()), 1e-10 * std::max(input, 1.0));
    ASSERT_LT((mirror.asDiagonal() * motion.drift() - mirrored.drift()).cwiseAbs().maxCoeff(),
              1e-11);
    yaw = std::max(yaw, std::abs(motion.yaw(4)));
  }
  EXPECT_GT(yaw, 1e-3);
  EXPECT_GT(motion.energy().hysteresis, 0.3 * motion.energy().input);
  EXPECT_LT(motion.energy().kinetic, 1e-3 * motion.energy().input) << "it rests";
}

}  // namespace
}  // namespace gurney::groundmotions
