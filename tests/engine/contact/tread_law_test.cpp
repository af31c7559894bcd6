#include "engine/contact/tread_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gurney {
namespace {

constexpr double kRadius = 0.05, kTau = 1e-3;

Tread tread() {
  Tread t;
  t.tangential_damping = 20;
  t.patch_width = 0.008;
  t.rolling_friction_length = 1e-3;
  t.static_friction = 0.8;
  t.kinetic_friction = 0.5;
  return t;
}

TreadLaw law() { return TreadLaw(tread(), kRadius); }

using Matrix5 = Eigen::Matrix<double, 5, 5>;

struct Stage {
  double compression = 1e-3;  ///< at zero u_z
  double rolling_speed = 0;
  TreadState start;
  double tau = kTau;
};

/// A stage that ends at this compression when the wheel does not move vertically.
Stage stage(double compression = 1e-3, double rolling_speed = 0) {
  return {.compression = compression, .rolling_speed = rolling_speed, .start = {}};
}

TreadStage<double> inputs(const TreadLaw& of, const Stage& s) {
  TreadStage<double> result;
  result.tau = s.tau;
  result.compression = s.compression;
  result.mu = of.friction(s.start);
  result.deflection = splat<double>(s.start.deflection);
  result.roll_deflection = s.start.roll_deflection;
  result.set_rolling(of.constants(), s.rolling_speed);
  return result;
}

TreadRates<double> of_vector(const Vector5& u) { return {{u[0], u[1], u[3]}, u[2], u[4]}; }

/// f(u); `slope` becomes -df/du.
Vector5 force(const TreadLaw& of, const Stage& s, const Vector5& u, Matrix5& slope) {
  TreadForce<double> f;
  TreadSlope<double> d;
  tread_force(of.constants(), inputs(of, s), of_vector(u), f, d);
  const auto& [x, y, z] = d.patch;
  slope << x.x, y.x, d.by_normal.x, z.x, 0,  //
      x.y, y.y, d.by_normal.y, z.y, 0,       //
      0, 0, d.normal, 0, 0,                  //
      x.z, y.z, d.by_normal.z, z.z, 0,       //
      0, 0, d.roll_by_normal, 0, d.roll;
  return (Vector5() << f.patch.x, f.patch.y, f.normal, f.patch.z, f.roll).finished();
}

Vector5 rates(double x, double y, double z, double spin = 0, double roll = 0) {
  return (Vector5() << x, y, z, spin, roll).finished();
}

Vector5 force(const Stage& s, const Vector5& u, const TreadLaw& of = law()) {
  Matrix5 slope;
  return force(of, s, u, slope);
}

TreadLaw::Result finish(const Stage& s, const Vector5& u, const TreadLaw& of = law()) {
  const Vector5 f = force(s, u, of);
  const auto o = tread_outcome(of.constants(), inputs(of, s), of_vector(u),
                               TreadForce<double>{{f[0], f[1], f[3]}, f[2], f[4]});
  return {.force = f,
          .end = {.deflection = {o.deflection.x, o.deflection.y, o.deflection.z},
                  .roll_deflection = o.roll_deflection,
                  .sliding = o.slides,
                  .rolling = o.rolls},
          .compression = o.compression,
          .compression_rate = o.compression_rate,
          .sliding_power = o.sliding_power,
          .rolling_power = o.rolling_power,
          .relaxation_power = o.relaxation_power,
          .damping_power = o.damping_power,
          .slip_speed = o.slip_speed,
          .spring_rates = o.spring_rates};
}

double patch_force(const Vector5& f) { return std::hypot(f[0], f[1], f[3]); }

TEST(TreadLaw, StandingItCarriesStiffnessTimesCompression) {
  EXPECT_DOUBLE_EQ(force(stage(1e-3), rates(0, 0, 0))[2], 300);
  EXPECT_DOUBLE_EQ(law().static_force(1e-3), 300);
  EXPECT_EQ(law().static_force(-1e-3), 0);
}

TEST(TreadLaw, CompressionAtTheEndOfTheStageCounts) {
  // Sinking at 0.1 m/s for 1 ms: 0.1 mm deeper, and 500 N s/m * 0.1 m/s of damping.
  EXPECT_NEAR(force(stage(1e-3), rates(0, 0, -0.1))[2], 3e5 * 1.1e-3 + 50, 1e-9);
  const auto result = finish(stage(1e-3), rates(0, 0, -0.1));
  EXPECT_NEAR(result.compression, 1.1e-3, 1e-18);
  EXPECT_EQ(result.compression_rate, 0.1);
}

TEST(TreadLaw, NeverPulls) {
  for (double compression : {-1e-3, -1e-6, 0.0, 1e-6, 1e-4, 1e-3})
    for (double z = -5; z <= 5; z += 0.01) {
      const Vector5 f = force(stage(compression), rates(0.3, 0, z));
      EXPECT_GE(f[2], 0);
      if (compression - kTau * z <= 0) {
        EXPECT_EQ(f.norm(), 0) << "off the floor nothing acts";
      }
    }
}

TEST(TreadLaw, IsContinuousAtZeroCompressionHoweverFastItLands) {
  // Without the bound of the damping by the elastic force, landing at 2 m/s would jump to 1000 N.
  for (double z : {-2.0, -0.5, 0.5, 2.0}) {
    const double depth = 1e-9;
    const Vector5 f = force(stage(depth + kTau * z), rates(0, 0, z));
    EXPECT_LE(f[2], 2 * 3e5 * depth * (1 + 1e-6));
  }
}

TEST(TreadLaw, DampingIsBoundedByTheElasticForceBothWays) {
  // c_n |z| = 1000 N against k_n d = 300 N.
  EXPECT_NEAR(force(stage(1e-3 - 2 * kTau), rates(0, 0, -2))[2], 600, 1e-9);
  EXPECT_NEAR(force(stage(1e-3 + 2 * kTau), rates(0, 0, 2))[2], 0, 1e-9);
}

TEST(TreadLaw, AStuckPatchIsASpringAndADamper) {
  auto s = stage();
  s.start.deflection = {2e-5, -1e-5, 1e-5};
  const Vector5 f = force(s, rates(0.01, 0.02, 0, 0.005));
  const Vector3 end = s.start.deflection + kTau * Vector3(0.01, 0.02, 0.005);
  const Vector3 expected = -1e5 * end - 20 * Vector3(0.01, 0.02, 0.005);
  EXPECT_NEAR(f[0], expected[0], 1e-12);
  EXPECT_NEAR(f[1], expected[1], 1e-12);
  EXPECT_NEAR(f[3], expected[2], 1e-12);
  const auto result = finish(s, rates(0.01, 0.02, 0, 0.005));
  EXPECT_NEAR((result.end.deflection - end).norm(), 0, 1e-18);
  EXPECT_FALSE(result.end.sliding);
  EXPECT_EQ(result.sliding_power, 0);
  EXPECT_NEAR(result.damping_power, 20 * (0.01 * 0.01 + 0.02 * 0.02 + 0.005 * 0.005), 1e-12);
}

TEST(TreadLaw, StickDoesNotCreep) {
  // A load below the limit for ten minutes: implicit stages under the force that balances it.
  auto s = stage();
  const double load = 0.79 * 300;  // of mu_s N = 240
  s.start.deflection = {-load / 1e5, 0, 0};
  for (int i = 0; i < 600000; i += 1) {
    const auto result = finish(s, rates(0, 0, 0));
    ASSERT_EQ(result.end.deflection, s.start.deflection);
    ASSERT_FALSE(result.end.sliding);
    s.start = result.end;
  }
  EXPECT_DOUBLE_EQ(force(s, rates(0, 0, 0))[0], load);
}

TEST(TreadLaw, TranslationAndSpinShareOneIsotropicLimit) {
  for (double a = 0; a < 6.3; a += 0.3)
    for (double b = -1.5; b < 1.6; b += 0.3) {
      const Vector3 way(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
      const Vector5 f = force(stage(), rates(5 * way.x(), 5 * way.y(), 0, 5 * way.z()));
      EXPECT_NEAR(patch_force(f), 0.8 * 300, 1e-9);
      EXPECT_NEAR((Vector3(f[0], f[1], f[3]) / 240 + way).norm(), 0, 1e-12) << "opposes the slip";
    }
  EXPECT_DOUBLE_EQ(law().spin_radius(), 0.002);
}

TEST(TreadLaw, SlidingRemembersTheKineticCoefficientUntilItSticksAgain) {
  auto s = stage();
  const auto first = finish(s, rates(5, 0, 0));
  EXPECT_NEAR(first.force[0], -240, 1e-9);  // breaks loose at mu_s N
  EXPECT_TRUE(first.end.sliding);
  s.start = first.end;
  const auto second = finish(s, rates(5, 0, 0));
  EXPECT_NEAR(second.force[0], -150, 1e-9);  // slides at mu_k N
  s.start = second.end;
  // Turned back, the deflection falls below what mu_k N holds: it sticks, and mu_s is back.
  const auto stuck = finish(s, rates(-0.5, 0, 0));
  EXPECT_FALSE(stuck.end.sliding);
  s.start = stuck.end;
  EXPECT_NEAR(finish(s, rates(5, 0, 0)).force[0], -240, 1e-9);
}

TEST(TreadLaw, SlidingPowerIsForceTimesSlip) {
  auto s = stage();
  s.start.sliding = true;
  s.start.deflection = {-150 / 1e5 * -1, 0, 0};
  const auto result = finish(s, rates(2, 0, 0));
  EXPECT_NEAR(result.sliding_power, 150 * 2, 1e-9);
  EXPECT_NEAR(result.slip_speed, 2, 1e-9);
}

TEST(TreadLaw, ARollingPatchForgetsOverTheRelaxationLength) {
  // Implicit steps of e' = -(V / sigma) e: each divides by 1 + tau V / sigma.
  Tread t = tread();
  t.tangential_damping = 0;
  const TreadLaw undamped(t, kRadius);
  auto s = stage(1e-3, 0.5);
  s.tau = 1e-6;
  s.start.deflection = {1e-4, -2e-4, 5e-5};
  const Vector3 start = s.start.deflection;
  double relaxed = 0;
  for (int i = 0; i < 20000; ++i) {  // 20 ms at 0.5 m/s: one sigma of 10 mm
    const auto result = finish(s, rates(0, 0, 0), undamped);
    relaxed += s.tau * result.relaxation_power;
    s.start = result.end;
  }
  // Implicit Euler with tau V / sigma = 5e-5: 2.5e-5 of the exponent.
  EXPECT_NEAR((s.start.deflection - std::exp(-1.0) * start).norm(), 0, 5e-5 * start.norm());
  const double lost = 0.5 * 1e5 * (start.squaredNorm() - s.start.deflection.squaredNorm());
  EXPECT_NEAR(relaxed, lost, 1e-4 * lost);
}

TEST(TreadLaw, RollingResistanceIsBoundedAndOpposesTheRoll) {
  auto s = stage();
  for (double roll : {-3.0, 3.0}) {
    const auto result = finish(s, rates(0, 0, 0, 0, roll));
    EXPECT_DOUBLE_EQ(result.force[4], std::copysign(1e-3 * 300, -roll));
    EXPECT_TRUE(result.end.rolling);
  }
  // Stuck: a spring of 10 k_t R^2.
  const auto stuck = finish(s, rates(0, 0, 0, 0, 1e-2));
  EXPECT_NEAR(stuck.force[4], -10 * 1e5 * kRadius * kRadius * 1e-5, 1e-12);
  EXPECT_FALSE(stuck.end.rolling);
  EXPECT_EQ(stuck.rolling_power, 0);
}

/// -df/du by central differences, largest deviation relative to the largest slope.
double slope_error(const TreadLaw& l, const Stage& s, const Vector5& u) {
  Matrix5 slope, ignored, numeric;
  force(l, s, u, slope);
  const double step = 1e-7;
  for (int k = 0; k < 5; ++k) {
    const Vector5 d = step * Vector5::Unit(k);
    numeric.col(k) = -(force(l, s, u + d, ignored) - force(l, s, u - d, ignored)) / (2 * step);
  }
  return (slope - numeric).cwiseAbs().maxCoeff() / std::max(slope.cwiseAbs().maxCoeff(), 1.0);
}

TEST(TreadLaw, SlopesAreThoseOfTheForceInEveryRegime) {
  // Central differences over 1e-7: rounding 300 N * 1e-16 / 1e-7 and third derivatives stay below
  // 1e-6 of slopes of 100 to 1e3 N s/m.
  auto s = stage();
  s.start.deflection = {1e-4, 2e-4, -1e-4};
  s.start.roll_deflection = 1e-5;
  EXPECT_LT(slope_error(law(), s, rates(0.01, 0.02, 0.03, 0.01, 0.01)), 1e-6) << "sticks";
  EXPECT_LT(slope_error(law(), s, rates(1, -2, 0.03, 0.4, 0.01)), 1e-6) << "slides";
  EXPECT_TRUE(finish(s, rates(1, -2, 0.03, 0.4, 0.01)).end.sliding);
  EXPECT_LT(slope_error(law(), s, rates(0.01, 0, -0.1, 0, 3)), 1e-6) << "rolls";
  EXPECT_LT(slope_error(law(), s, rates(1, 2, -2, 0.3, -3)), 1e-6) << "damping capped above";
  EXPECT_EQ(slope_error(law(), s, rates(1, 2, 0.9, 0.3, -3)), 0) << "damping capped below";
  EXPECT_EQ(slope_error(law(), stage(-1e-3), rates(1, 2, 0, 0.3, -3)), 0) << "lifted";
  s.rolling_speed = 0.7;
  s.start.sliding = true;
  EXPECT_LT(slope_error(law(), s, rates(0.01, 0.02, 0, 0.01, 14)), 1e-6) << "relaxing";
  EXPECT_TRUE(finish(s, rates(3, 0.5, 0.01, 0.1, 14)).end.sliding);
  EXPECT_LT(slope_error(law(), s, rates(3, 0.5, 0.01, 0.1, 14)), 1e-6) << "relaxing and sliding";
}

TEST(TreadLaw, PowersAccountForTheWorkOfTheForce) {
  // -f . u = rate of stored energy + losses, with the spring's own rate at the end of the stage.
  auto s = stage(1e-3, 0.4);
  s.start.deflection = {1e-4, -2e-4, 1e-4};
  s.start.roll_deflection = 1e-4;
  for (const Vector5& u : {rates(0.02, 0.01, 0.01, 0.02, 0.1), rates(3, -4, -0.1, 0.5, 8),
                           rates(0.3, 0, -2, 0, -4), rates(0, 0, 0.4, 0, 0)}) {
    const auto r = finish(s, u);
    const Vector3 rate = (r.end.deflection - s.start.deflection) / kTau;
    const double roll_rate = (r.end.roll_deflection - s.start.roll_deflection) / kTau;
    const double stored = 3e5 * r.compression * r.compression_rate +
                          1e5 * r.end.deflection.dot(rate) +
                          10 * 1e5 * kRadius * kRadius * r.end.roll_deflection * roll_rate;
    const double loss = r.sliding_power + r.rolling_power + r.relaxation_power + r.damping_power;
    EXPECT_NEAR(-r.force.dot(u), stored + loss, 1e-9 * std::max(1.0, std::abs(loss)));
    EXPECT_GE(r.sliding_power, 0);
    EXPECT_GE(r.rolling_power, 0);
    EXPECT_GE(r.relaxation_power, 0);
    EXPECT_GE(r.damping_power, 0);
  }
}

TEST(TreadLaw, ALiftedPatchForgetsEverything) {
  auto s = stage(-1e-3);
  s.start.deflection = {1e-4, 0, 0};
  s.start.sliding = s.start.rolling = true;
  const auto result = finish(s, rates(1, 1, 0, 1, 1));
  EXPECT_EQ(result.force.norm(), 0);
  EXPECT_EQ(result.end.deflection.norm(), 0);
  EXPECT_FALSE(result.end.sliding);
  EXPECT_FALSE(result.end.rolling);
}

}  // namespace
}  // namespace gurney
