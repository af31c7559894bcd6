#include "engine/caster/caster_dynamics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "engine/caster/caster_energy.h"
#include "engine/caster/contact_jacobian.h"
#include "studies/verification/scenes/small_scenes.h"
#include "tests/support/caster_matrices.h"

// The mass matrix, bias and contact Jacobian of a caster against an independent sum over its parts:
// the fork and the wheel as two rigid bodies, each moved by plain kinematics.
namespace gurney {
namespace {

Caster odd_caster(bool swivels = true) {
  Caster c = small::caster({0.4, -0.2, 0.131}, 30, small::bare_tread(3e5, 1e5));
  c.fork_mass = 0.7;
  c.fork_center_of_mass = {-0.02, 0.006, -0.04};
  c.fork_inertia << 4e-3, 3e-4, -2e-4, 3e-4, 5e-3, 1e-4, -2e-4, 1e-4, 3e-3;
  c.wheel_mass = 0.9;
  c.wheel_axial_inertia = 1.2e-3;
  c.wheel_transverse_inertia = 7e-4;
  c.tread.patch_width = 0.02;
  c.swivels = swivels;
  return c;
}

const Vector3 kChassisCenter(0.05, 0.02, 0.6);

struct Motion {
  Pose pose;
  double swivel_angle = 0;
  Vector6 velocity = Vector6::Zero();
  Eigen::Vector2d rates = Eigen::Vector2d::Zero();
};

class Random {
 public:
  double operator()() { return std::ldexp(static_cast<double>(engine_()), -31) - 1; }
  Vector3 vector(double size) { return size * Vector3((*this)(), (*this)(), (*this)()); }
  Motion motion(bool swivels) {
    Motion m;
    m.pose.position = vector(1);
    m.pose.rotation =
        Quaternion(1, 0.3 * (*this)(), 0.3 * (*this)(), (*this)()).normalized().toRotationMatrix();
    m.swivel_angle = swivels ? 3 * (*this)() : odd_caster().heading;
    m.velocity << vector(2), vector(3);
    m.rates = {swivels ? 5 * (*this)() : 0, 40 * (*this)()};
    return m;
  }

 private:
  std::mt19937 engine_{3};
};

struct Part {
  double mass;
  Vector3 position, velocity, spin;
  Matrix3 inertia;
};

/// Fork and wheel at a motion.
std::array<Part, 2> parts(const Caster& c, const Motion& m) {
  const Matrix3 fork =
      m.pose.rotation * Eigen::AngleAxisd(m.swivel_angle, Vector3::UnitZ()).toRotationMatrix();
  const Vector3 v = m.velocity.head<3>(), w = m.velocity.tail<3>();
  const Vector3 mount = m.pose.rotation * (c.mount - kChassisCenter);
  const Vector3 fork_spin = w + m.rates[0] * fork.col(2);
  const auto at = [&](double mass, const Vector3& local, const Vector3& spin,
                      const Matrix3& inertia) {
    const Vector3 arm = fork * local;
    return Part{mass, m.pose.position + mount + arm, v + w.cross(mount) + fork_spin.cross(arm),
                spin, fork * inertia * fork.transpose()};
  };
  const double t = c.wheel_transverse_inertia;
  return {
      at(c.fork_mass, c.fork_center_of_mass, fork_spin, c.fork_inertia),
      at(c.wheel_mass, {-c.trail, 0, -(c.height - c.wheel_radius)},
         fork_spin + m.rates[1] * fork.col(1), Vector3(t, c.wheel_axial_inertia, t).asDiagonal())};
}

CasterMatrices geometry(const CasterDynamics& dynamics, const Motion& m,
                        const Vector3& gravity = Vector3::Zero()) {
  return caster_matrices(dynamics, m.pose, m.swivel_angle, m.velocity, m.rates, gravity);
}

CasterEnergy<double> energy(const CasterDynamics& dynamics, const Motion& m,
                            const Vector3& gravity) {
  CasterMotion<double> motion;
  motion.rotation = splat<double>(m.pose.rotation);
  motion.sine = std::sin(m.swivel_angle);
  motion.cosine = std::cos(m.swivel_angle);
  motion.angular_velocity = splat<double>(Vector3(m.velocity.tail<3>()));
  motion.swivel_rate = m.rates[0];
  motion.axle_rate = m.rates[1];
  motion.gravity = splat<double>(gravity);
  CasterGeometry<double> g;
  const Mat3<double> fork = contact_geometry(dynamics.constants(), motion, g);
  return caster_energy(dynamics.constants(), motion, splat<double>(Vector3(m.velocity.head<3>())),
                       fork);
}

/// The motion a little later at constant acceleration.
Motion later(const Motion& m, const Vector6& acceleration, const Eigen::Vector2d& joints,
             double time) {
  Motion n = m;
  n.velocity += time * acceleration;
  n.rates += time * joints;
  n.pose.position += time * 0.5 * (m.velocity + n.velocity).head<3>();
  const Vector3 turn = time * 0.5 * (m.velocity + n.velocity).tail<3>();
  n.pose.rotation =
      Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * m.pose.rotation;
  n.swivel_angle += time * 0.5 * (m.rates[0] + n.rates[0]);
  return n;
}

TEST(CasterDynamics, KineticEnergyIsTheSumOverItsParts) {
  Random random;
  for (bool swivels : {true, false}) {
    const Caster caster = odd_caster(swivels);
    const CasterDynamics dynamics(caster, kChassisCenter);
    for (int trial = 0; trial < 50; ++trial) {
      const Motion m = random.motion(swivels);
      double expected = 0;
      for (const Part& p : parts(caster, m))
        expected += 0.5 * p.mass * p.velocity.squaredNorm() + 0.5 * p.spin.dot(p.inertia * p.spin);
      const auto g = geometry(dynamics, m);
      const double by_mass = 0.5 * m.velocity.dot(g.mass_chassis * m.velocity) +
                             m.velocity.dot(g.mass_coupling * m.rates) +
                             0.5 * m.rates.dot(g.mass_joints * m.rates);
      EXPECT_NEAR(by_mass, expected, 1e-12 * expected);
      EXPECT_NEAR(energy(dynamics, m, Vector3::Zero()).kinetic, expected, 1e-12 * expected);
    }
  }
}

TEST(CasterDynamics, GravitationalEnergyIsTheSumOverItsParts) {
  Random random;
  const Caster caster = odd_caster();
  const CasterDynamics dynamics(caster, kChassisCenter);
  const Vector3 gravity(0.4, -0.7, -9.8);
  for (int trial = 0; trial < 50; ++trial) {
    const Motion m = random.motion(true);
    double expected = 0;
    for (const Part& p : parts(caster, m))
      expected -= p.mass * gravity.dot(p.position - m.pose.position);
    // Of the order of 1 J: two masses of 1 kg within 1 m.
    EXPECT_NEAR(energy(dynamics, m, gravity).gravitational, expected, 1e-13);
  }
}

TEST(CasterDynamics, ContactIsThatOfTheWholeGeometry) {
  Random random;
  for (bool swivels : {true, false}) {
    const CasterDynamics dynamics(odd_caster(swivels), kChassisCenter);
    for (int trial = 0; trial < 50; ++trial) {
      const Motion m = random.motion(swivels);
      const auto whole = geometry(dynamics, m);
      const CasterGeometry<double> g = dynamics.contact(m.pose, m.swivel_angle);
      EXPECT_EQ(lane(g.contact, 0), whole.contact);
      EXPECT_EQ(g.height, whole.height);
      const TreadRates<double> u = contact_rates<double>(
          g, dynamics.constants().spin_radius, {splat<double>(m.velocity), m.rates[0], m.rates[1]});
      const Vector5 rates = whole.jacobian_chassis * m.velocity + whole.jacobian_joints * m.rates;
      const Vector5 found =
          (Vector5() << u.patch.x, u.patch.y, u.normal, u.patch.z, u.roll).finished();
      EXPECT_NEAR((found - rates).norm(), 0, 1e-13 * rates.norm());
    }
  }
}

TEST(CasterDynamics, MomentumIsTheSumOverItsParts) {
  Random random;
  const Caster caster = odd_caster();
  const CasterDynamics dynamics(caster, kChassisCenter);
  for (int trial = 0; trial < 50; ++trial) {
    const Motion m = random.motion(true);
    Vector6 expected = Vector6::Zero();
    for (const Part& p : parts(caster, m)) {
      const Vector3 r = p.position - m.pose.position;
      expected.head<3>() += p.mass * p.velocity;
      expected.tail<3>() += p.mass * r.cross(p.velocity) + p.inertia * p.spin;
    }
    const auto g = geometry(dynamics, m);
    const Vector6 found = g.mass_chassis * m.velocity + g.mass_coupling * m.rates;
    EXPECT_NEAR((found - expected).norm(), 0, 1e-12 * expected.norm());
  }
}

TEST(CasterDynamics, ForcesAreTheRateOfMomentumOfItsParts) {
  // M a + bias = d/dt of the momentum about O minus gravity (O itself moves: + v x p), by central
  // differences over 1e-5 s: truncation of the third derivative, 1e-10 times 40^3 of the momentum,
  // is about 1e-5.
  Random random;
  const Vector3 gravity(0.5, -1, -9);
  for (bool swivels : {true, false}) {
    const Caster caster = odd_caster(swivels);
    const CasterDynamics dynamics(caster, kChassisCenter);
    for (int trial = 0; trial < 20; ++trial) {
      const Motion m = random.motion(swivels);
      Vector6 a;
      a << random.vector(3), random.vector(5);
      const Eigen::Vector2d b(swivels ? 10 * random() : 0, 50 * random());
      const auto momentum = [&](const Motion& n) {
        Vector6 sum = Vector6::Zero();
        for (const Part& p : parts(caster, n)) {
          sum.head<3>() += p.mass * p.velocity;
          sum.tail<3>() +=
              p.mass * (p.position - m.pose.position).cross(p.velocity) + p.inertia * p.spin;
        }
        return sum;
      };
      const double h = 1e-5;
      Vector6 expected = (momentum(later(m, a, b, h)) - momentum(later(m, a, b, -h))) / (2 * h);
      for (const Part& p : parts(caster, m)) {
        expected.head<3>() -= p.mass * gravity;
        expected.tail<3>() -= p.mass * (p.position - m.pose.position).cross(gravity);
      }
      const auto g = geometry(dynamics, m, gravity);
      const Vector6 found = g.mass_chassis * a + g.mass_coupling * b + g.bias_chassis;
      EXPECT_LT((found - expected).norm(), 1e-6 * expected.norm());
    }
  }
}

TEST(CasterDynamics, AForkThatDoesNotSwivelHasNoSwivelInertiaOrForce) {
  Random random;
  const CasterDynamics dynamics(odd_caster(false), kChassisCenter);
  const auto g = geometry(dynamics, random.motion(false), {0, 0, -9});
  EXPECT_EQ(g.mass_coupling.col(0).norm(), 0);
  EXPECT_EQ(g.mass_joints(0, 1), 0);
  EXPECT_GT(g.mass_joints(0, 0), 0);  // only so that it can be inverted
  EXPECT_EQ(g.bias_joints[0], 0);
  EXPECT_EQ(g.jacobian_joints.col(0).norm(), 0);
}

TEST(CasterDynamics, ContactIsTheLowestPointOfACrownedTread) {
  // The tread as circles side by side: at y from the middle its slope is the lean of 10 to 30
  // degrees that stands on it, so the radius there is smaller by the integral of tan(lean) dy.
  constexpr double kBegin = std::numbers::pi / 18, kEnd = std::numbers::pi / 6;
  constexpr int kCircles = 2000;
  Random random;
  const Caster caster = odd_caster();
  const CasterDynamics dynamics(caster, kChassisCenter);
  const double half = 0.5 * caster.wheel_width;
  int upright = 0, crown = 0, edge = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Motion m = random.motion(true);
    const auto g = geometry(dynamics, m);
    const Matrix3 fork =
        m.pose.rotation * Eigen::AngleAxisd(m.swivel_angle, Vector3::UnitZ()).toRotationMatrix();
    const Vector3 axle = fork.col(1);
    const double lean = std::asin(std::abs(axle.z()));
    ++(lean < kBegin ? upright : lean < kEnd ? crown : edge);
    double lowest = 1e9;
    for (int k = -kCircles; k <= kCircles; ++k) {
      const double y = half * k / kCircles;
      const double slope = kBegin + std::abs(y) / half * (kEnd - kBegin);
      const double radius = caster.wheel_radius -
                            half / (kEnd - kBegin) * std::log(std::cos(kBegin) / std::cos(slope));
      lowest = std::min(lowest, (g.wheel_center + y * axle).z() - radius * std::cos(lean));
    }
    // Between circles dy apart the height misses dy^2 / 8 (d lean / dy) / cos(lean), at most
    // 0.349 / (8 2000^2 0.866) = 1.26e-8 of half.
    EXPECT_NEAR(g.contact.z(), lowest, 1.3e-8 * half);
    EXPECT_NEAR(g.height, m.pose.position.z() + g.contact.z(), 1e-15);
  }
  EXPECT_GT(upright, 5);
  EXPECT_GT(crown, 5);
  EXPECT_GT(edge, 2);
}

TEST(CasterDynamics, JacobianGivesTheVelocityOfTheMaterialContactPoint) {
  Random random;
  const Caster caster = odd_caster();
  const CasterDynamics dynamics(caster, kChassisCenter);
  for (int trial = 0; trial < 20; ++trial) {
    const Motion m = random.motion(true);
    const auto g = geometry(dynamics, m);
    const Part wheel = parts(caster, m)[1];
    const Vector3 arm = m.pose.position + g.contact - wheel.position;
    const Vector3 expected = wheel.velocity + wheel.spin.cross(arm);
    const Vector5 u = g.jacobian_chassis * m.velocity + g.jacobian_joints * m.rates;
    EXPECT_NEAR((u.head<3>() - expected).norm(), 0, 1e-13 * (1 + expected.norm()));
    EXPECT_NEAR(u[3], caster.tread.patch_width / 4 * wheel.spin.z(), 1e-14);
    EXPECT_NEAR(u[4], wheel.spin.dot(g.axle_level), 1e-12);
    EXPECT_NEAR(g.axle_level.z(), 0, 0);
    EXPECT_NEAR(g.heading.dot(g.axle_level), 0, 1e-15);
  }
}

TEST(CasterDynamics, AWheelThatRollsForwardTurnsPositively) {
  const CasterDynamics dynamics(odd_caster(), kChassisCenter);
  Motion m;
  m.pose.position = {0, 0, kChassisCenter.z()};
  m.swivel_angle = 0.4;
  m.velocity.head<3>() = Vector3(std::cos(0.4), std::sin(0.4), 0);
  m.rates = {0, 1 / 0.05};
  const auto g = geometry(dynamics, m);
  const Vector5 u = g.jacobian_chassis * m.velocity + g.jacobian_joints * m.rates;
  EXPECT_NEAR(u.head<3>().norm(), 0, 1e-14);
  EXPECT_NEAR(u[4], 20, 1e-12);
}

}  // namespace
}  // namespace gurney
