#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/wind_up.h"

// A trolley pulled by a constant force and left to coast: Xu, Ma & Kurata 2022, 5th SPONSE
// workshop. With M the mass, J = sum I_w / R^2 and f_r = (Cr / R) M g (Newton's law for cart and
// wheels):
//
//     a1 = (F - f_r) / (M + J),   a2 = f_r / (M + J)
namespace gurney {
namespace {

using namespace scenes;

constexpr double kG = kStandardGravity;

struct Motion {
  double displacement, velocity;
};

/// Uniform acceleration a1 for `pull`, then uniform deceleration a2 to rest.
Motion pull_and_coast(double a1, double pull, double a2, double time) {
  if (time <= pull) return {a1 * time * time / 2, a1 * time};
  const double v1 = a1 * pull, coast = std::min(time - pull, v1 / a2);
  return {v1 * pull / 2 + v1 * coast - a2 * coast * coast / 2, v1 - a2 * coast};
}

struct PullCase {
  const char* name;
  double force, duration, resistance;  // F [N], [s], Cr / R
  double mass = 96.5, wheel_mass = 0.25, wheel_radius = 0.05;
};

std::ostream& operator<<(std::ostream& out, const PullCase& c) { return out << c.name; }

EquipmentModel pulled_trolley(const PullCase& c, double normal_stiffness) {
  ItemOptions options;
  options.total_mass = c.mass;
  Caster& caster = options.caster;
  stiffen(caster.tread);
  caster.tread.normal_stiffness = normal_stiffness;
  caster.wheel_mass = c.wheel_mass;
  caster.wheel_radius = c.wheel_radius;
  caster.height = c.wheel_radius + 0.081;
  caster.tread.rolling_resistance = c.resistance * c.wheel_radius;
  set_wheel_inertia(caster);
  return trolley(options);
}

struct Errors {
  double displacement = 0,
         velocity = 0;  // of the centre of mass: largest, over the largest exact value
};

Errors pull(const PullCase& c, double normal_stiffness, double time_step, const Fixture& fixture) {
  Scene scene;
  scene.items[0].model = pulled_trolley(c, normal_stiffness);
  Excitation excitation;
  excitation.fixture = fixture;
  excitation.forces = {
      constant_force(c.force, c.duration, scene.items[0].model.marked_points[0].position)};
  const double mass = total_mass(scene.items[0].model), resistance = c.resistance * mass * kG;
  const double inertia = mass + wheel_inertia_mass(scene.items[0].model);
  const double a1 = (c.force - resistance) / inertia, a2 = resistance / inertia;
  const double v1 = a1 * c.duration, stop = v1 / a2;
  const double distance = v1 * (c.duration + stop) / 2;

  const auto response =
      simulate(scene, excitation, run_for(c.duration + stop + 1, time_step, 0.02));
  EXPECT_EQ(response.outcome, Outcome::kStopped);
  EXPECT_EQ(response.quality.unconverged_steps, 0);
  Errors errors;
  for (const Sample& s : response.items[0].history) {
    const PointSample& center = s.points[0];  // the item's origin swings as the trolley pitches
    const Motion exact = pull_and_coast(a1, c.duration, a2, s.time);
    errors.displacement = std::max(
        errors.displacement, std::abs(center.displacement.x() - exact.displacement) / distance);
    errors.velocity =
        std::max(errors.velocity, std::abs(center.velocity.x() - exact.velocity) / v1);
  }
  errors.displacement =
      std::max(errors.displacement,
               std::abs(response.items[0].demands.residual_displacement_x / distance - 1));
  return errors;
}

class ConstantPull : public testing::TestWithParam<PullCase> {};

// 0.1 % at a step of 4 ms with k_n = 3e6. What is left is pitching on the treads when
// the force starts (about k_n^-1/2) and the wind-up below.
TEST_P(ConstantPull, AgreesWithin0p1PercentAt4ms) {
  const Errors errors = pull(GetParam(), 3e6, 0.004, {});
  EXPECT_LT(errors.displacement, 1e-3);
  EXPECT_LT(errors.velocity, 1e-3);
}

// 0.01 % at 0.5 ms with the pitch held. What is left is the wind-up of the treads (wind_up.h): at
// most 4e-5 of the velocities here at k_t = 1e9.
TEST_P(ConstantPull, AgreesWithin0p01PercentAtHalfAMillisecond) {
  const Errors errors = pull(GetParam(), 3e8, 0.0005, hold_rotations(false, true, false));
  EXPECT_LT(errors.displacement, 1e-4);
  EXPECT_LT(errors.velocity, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(
    Pulls, ConstantPull,
    testing::Values(PullCase{"light", 40, 3, 0.02}, PullCase{"strong", 80, 1.5, 0.03},
                    PullCase{"loaded", 60, 2, 0.015, 164.5},
                    PullCase{"heavy_wheels", 50, 2, 0.02, 96.5, 1.5},
                    PullCase{"large_wheels", 35, 2.5, 0.01, 96.5, 0.6, 0.0625}),
    [](const auto& c) { return c.param.name; });

// A wheel does not resist in full at once: its tread and the stuck rolling resistance wind up.
// They are springs in series, k_t and 10 k_t at the rim (engine/contact/tread_law.cpp), so with
// k = n k_t 10 / 11 and the wheels turning by 1/11 of the motion, the trolley is an oscillator
// until the resistance is reached at x1 = f_r / k:
//
//     x = F / k (1 - cos(w t)),  w^2 = k / M,   v1^2 = f_r (2 F - f_r) / (k M)
//
// and accelerates uniformly from x1, v1 on. Not in the formula, per unit of v1: the damping of the
// patch, (2/3) n c_t x1 / (M v1), and the wheels that spin up from 1/11 to 1, (10/11) J / M.
TEST(SoftTread, PullsAsTheClosedFormWithWindUp) {
  for (const double force : {30.0, 40.0, 80.0}) {
    SCOPED_TRACE(force);
    const double duration = 90 / force;
    Scene scene;
    scene.items[0].model = trolley();  // k_t = 1e5 N/m
    const Tread& tread = scene.items[0].model.casters[0].tread;
    const double mass = total_mass(scene.items[0].model),
                 inertia = wheel_inertia_mass(scene.items[0].model);
    const double resistance = tread.rolling_resistance / 0.05 * mass * kG;
    Excitation excitation;
    excitation.fixture = hold_rotations(false, true, false);
    excitation.forces = {constant_force(force, duration, {0, 0, 0.6})};

    const double k = 4 * tread.tangential_stiffness * 10 / 11, w = std::sqrt(k / mass);
    const double x1 = resistance / k, t1 = std::acos(1 - resistance / force) / w;
    const double v1 = std::sqrt(resistance * (2 * force - resistance) / (k * mass));
    const double a1 = (force - resistance) / (mass + inertia), t = duration - t1;
    const double velocity = v1 + a1 * t, displacement = x1 + v1 * t + a1 * t * t / 2;

    const auto response = simulate(scene, excitation, run_for(duration, 0.001, duration));
    const Sample& end = response.items[0].history.back();
    const double missing = 2.0 / 3 * 4 * tread.tangential_damping * x1 / mass +
                           10.0 / 11 * inertia / mass * v1;  // [m/s]
    EXPECT_NEAR(end.velocity.x(), velocity, 1.5 * missing);
    EXPECT_NEAR(end.displacement.x(), displacement, 1.5 * missing * duration);
    // The wind-up is no small thing: without it the same tolerance is missed by far.
    EXPECT_NEAR(velocity - a1 * duration, wind_up_speed(force, resistance, k, mass + inertia),
                0.01 * v1);
    EXPECT_GT(end.velocity.x() - a1 * duration, 10 * 1.5 * missing);
  }
}

}  // namespace
}  // namespace gurney
