#include "engine/solver/step_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>

#include "engine/run/simulate.h"
#include "engine/solver/equilibrium.h"
#include "engine/solver/quadrature.h"
#include "engine/solver/stepper.h"
#include "studies/verification/scenes/small_scenes.h"

namespace gurney {
namespace {

/// Of y' = lambda y a step misses by R(z) - exp(z); the accelerations are lambda times y at the
/// start and at the ends of the stages. Terms of the next order are about |z| times as large.
TEST(StepControl, EstimatesTheErrorOfLinearMotion) {
  using Complex = std::complex<double>;
  constexpr double kStep = 0.01;
  for (const Complex lambda : {Complex(-1, 0), Complex(0, 2), Complex(-1, 3)}) {
    const Complex z = kStep * lambda, first = 1.0 / (1.0 - kSdirkGamma * z);
    const Complex end = (1.0 + (1 - 2 * kSdirkGamma) * z) * first * first;
    const auto parts = [](const Complex& value) {
      Vector6 result = Vector6::Zero();
      result[0] = value.real(), result[4] = value.imag();
      return result;
    };
    const Vector6 estimate = StepControl::velocity_error(
        kStep, parts(lambda), parts(lambda * first), parts(lambda * end));
    const Vector6 error = parts(end - std::exp(z));
    // The estimate has the other sign.
    EXPECT_LT((estimate + error).norm(), 4 * std::abs(z) * error.norm()) << lambda;
    EXPECT_GT(error.norm(), 0.04 * std::pow(std::abs(z), 3));
  }
}

/// A heaving trolley, undamped, its wheels symmetric about its centre: z = v / w sin(w t). With e =
/// 1/3 - gamma a step of h misses the velocity by e (h w)^3 v |cos(w t)| and the phase by e (h
/// w)^3. Steps of which the former is the allowed share tau of v have a mean of (h w)^2 of (tau /
/// e)^(2/3) times the mean of |cos|^(-2/3), which is 2.32.
double heave_error(double tolerance) {
  constexpr double kSpeed = 0.02, kEnd = 0.5;
  Scene scene = scene_of(small::trolley({0, 180, 0, 180}, small::bare_tread(3e5, 1e5)));
  scene.items[0].initial.velocity = {0, 0, kSpeed};
  SimulationSettings settings = small::settings_for(0.004, kEnd);
  settings.tolerance = tolerance;
  const Response run = simulate(scene, {}, settings);
  const double w = std::sqrt(4 * 3e5 / 96.5);
  double worst = 0;
  for (const Sample& sample : run.items[0].history)
    worst =
        std::max(worst, std::abs(sample.displacement.z() * w / kSpeed - std::sin(w * sample.time)));
  const double tau = StepControl::kShareOfStep * tolerance;
  EXPECT_LT(worst, 2.32 * std::pow(tau, 2.0 / 3) * std::cbrt(1.0 / 3 - kSdirkGamma) * w * kEnd)
      << tolerance;
  return worst;
}

TEST(StepControl, ConvergesWithTheTolerance) {
  const double loose = heave_error(0.03), tight = heave_error(0.001);
  // 30^(2/3) = 9.7; steps that must end on the grid of 4 ms are up to half as long.
  EXPECT_GT(loose, 2.4 * tight);
}

/// A shaken trolley on a cord that breaks.
struct Tethered {
  Tethered() : scene(scene_of(small::trolley({10, 100, 200, 300}, Tread()))) {
    Tether cord;
    cord.name = "cord";
    cord.anchor = {0.6, 0, 0.5};
    cord.point = {0, 0, 0.5};
    cord.slack_length = 0.61;
    cord.stiffness = 2e4;
    cord.damping = 20;
    cord.strength = 100;
    scene.tethers.push_back(cord);
  }
  Scene scene;
  FloorMotion floor = small::noise_record(11, 4, {6, 4, 3});
};

bool same(const void* a, const void* b, std::size_t size) { return std::memcmp(a, b, size) == 0; }

/// The accepted steps alone, taken one by one without control, give the same bits: tried and
/// rejected ones leave nothing in the state, in what treads, bearings and tethers remember, or in
/// the energy account.
TEST(StepControl, RejectedStepsLeaveNoTrace) {
  const Tethered of;
  const Assembly assembly(of.scene);
  SceneState start;
  start.items.push_back(assembly.items[0].placed({}));
  settle(assembly, of.scene, 0, start);
  SimulationSettings settings;
  constexpr double kEnd = 3;

  std::vector<double> times;
  const Stepper::Observer note = [&](const Stepper::Step& step) { times.push_back(step.time); };
  settings.tolerance = 0.003;
  Stepper controlled(assembly, of.floor, settings);
  SceneState a = start;
  for (int k = 1; k * settings.time_step < kEnd; ++k)
    ASSERT_FALSE(controlled.advance(a, k * settings.time_step, note));
  times.push_back(a.items[0].time);
  EXPECT_GT(controlled.quality().rejected_steps, 10);
  EXPECT_EQ(a.items[0].broken_tethers, 1u);

  settings.tolerance = 0;
  Stepper plain(assembly, of.floor, settings);
  SceneState b = start;
  for (std::size_t k = 1; k < times.size(); ++k) ASSERT_FALSE(plain.advance(b, times[k], {}));
  EXPECT_EQ(plain.quality().steps, controlled.quality().steps);
  // The cord breaks inside a step of the one and at the end of one of the other.
  EXPECT_EQ(plain.quality().event_steps + 1, controlled.quality().event_steps);
  const State &x = a.items[0], &y = b.items[0];
  EXPECT_TRUE(same(x.position.data(), y.position.data(), sizeof x.position));
  EXPECT_TRUE(same(x.rotation.coeffs().data(), y.rotation.coeffs().data(), sizeof x.rotation));
  EXPECT_TRUE(
      same(x.velocity.chassis.data(), y.velocity.chassis.data(), sizeof x.velocity.chassis));
  EXPECT_EQ(x.broken_tethers, y.broken_tethers);
  for (std::size_t i = 0; i < 4; ++i) {
    const CasterState &p = x.casters[i], &q = y.casters[i];
    EXPECT_TRUE(
        same(p.tread.deflection.data(), q.tread.deflection.data(), sizeof p.tread.deflection));
    EXPECT_EQ(p.tread.roll_deflection, q.tread.roll_deflection);
    EXPECT_EQ(p.tread.sliding, q.tread.sliding);
    EXPECT_EQ(p.tread.rolling, q.tread.rolling);
    EXPECT_EQ(p.swivel_wind, q.swivel_wind);
    EXPECT_EQ(p.axle_wind, q.axle_wind);
    EXPECT_EQ(p.swivel_angle, q.swivel_angle);
  }
  EXPECT_EQ(controlled.accounts()[0].loss(), plain.accounts()[0].loss());
  EXPECT_EQ(controlled.accounts()[0].work_of_floor, plain.accounts()[0].work_of_floor);
}

TEST(StepControl, TheEnergyBalanceIsNoWorseThanWithFixedSteps) {
  const Tethered of;
  SimulationSettings settings = small::settings_for(0.004, 5, 5);
  const Response fixed = simulate(of.scene, of.floor, settings);
  settings.tolerance = 0.003;
  const Response controlled = simulate(of.scene, of.floor, settings);
  EXPECT_LE(controlled.quality.energy_closure, fixed.quality.energy_closure);
  EXPECT_LE(std::abs(controlled.quality.numerical_loss), std::abs(fixed.quality.numerical_loss));
}

}  // namespace
}  // namespace gurney
