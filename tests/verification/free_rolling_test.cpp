#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/scenes.h"

// What must be kept: speed without resistance, momentum (impulse of all forces), energy.
namespace gurney {
namespace {

using namespace scenes;

constexpr double kG = kStandardGravity;

// Nothing damps a free roller: no sleeping, no numerical drag. The solve may leave a residual of
// 1e-9 M g dt in each of 15000 steps, all in one direction at worst, 6e-7 m/s; it does not.
TEST(FreeRolling, KeepsItsSpeedTo1em9In60s) {
  for (const double speed : {0.1, 1.0, 3.0})
    for (const bool stiff : {false, true})
      for (const bool swivels : {false, true}) {
        SCOPED_TRACE(testing::Message() << speed << " m/s, stiff " << stiff << ", " << swivels);
        ItemOptions options;
        Caster& caster = options.caster;
        if (stiff) stiffen(caster.tread);
        caster.swivels = swivels;
        caster.tread.rolling_resistance = 0;
        caster.tread.tangential_damping = 100;  // above I_p v / trail^3: no flutter
        Scene scene;
        scene.items[0].model = trolley(options);
        scene.items[0].initial.velocity.x() = speed;
        const auto response = simulate(scene, {}, run_for(60, 0.004, 1));
        for (const Sample& s : response.items[0].history) {
          ASSERT_NEAR(s.velocity.x(), speed, 1e-9 * speed) << s.time;
          ASSERT_NEAR(s.displacement.x(), speed * s.time, 1e-9 * speed * 60) << s.time;
          ASSERT_NEAR(s.displacement.y(), 0, 1e-9) << s.time;
        }
        EXPECT_NEAR(response.items[0].energy.loss(), 0, 1e-9);
      }
}

// A trolley on rigid casters at odd headings under three components: it rolls, skids and turns.
// Being one rigid body (but for wheel spin, which carries no linear momentum), M v of its centre of
// mass must change by the impulse of the wheel forces, gravity and the floor's inertia.
struct Shaken {
  EquipmentModel item;
  Excitation excitation;
};

Shaken shaken(bool swivels, double amplitude = 0.3) {
  ItemOptions options;
  options.caster.swivels = swivels;
  options.headings = {0.2, -0.3, 0.1, 0.4};
  Shaken result;
  result.item = trolley(options);
  result.excitation.floor = floor_motion(0.004, 4, {1, 0.6, 0.4}, [=](double t) {
    return amplitude * kG * std::sin(std::numbers::pi * t / 4) *
           std::sin(2 * std::numbers::pi * 1.3 * t);
  });
  return result;
}

Response run(const Shaken& shaken, double time_step) {
  Scene scene;
  scene.items[0].model = shaken.item;
  return simulate(scene, shaken.excitation, run_for(4, time_step, time_step));
}

/// Largest |M v - impulse| over M times the peak velocity, by the trapezoidal rule on the samples.
double momentum_defect(const Shaken& scene, double time_step) {
  const auto response = run(scene, time_step);
  const double mass = total_mass(scene.item);
  const auto force = [&](const Sample& s) {
    Vector3 sum(0, 0, -mass * kG);
    for (std::size_t i = 0; i < 4; ++i) {
      const WheelSample& wheel = s.wheels[i];
      const double heading = scene.item.casters[i].heading + s.yaw;
      const Vector3 ahead(std::cos(heading), std::sin(heading), 0);
      sum += wheel.longitudinal_force * ahead +
             wheel.lateral_force * Vector3::UnitZ().cross(ahead) +
             wheel.normal_force * Vector3::UnitZ();
    }
    return Vector3(sum - mass * scene.excitation.floor.acceleration_at(s.time));
  };
  Vector3 impulse = Vector3::Zero();
  double defect = 0;
  for (std::size_t i = 1; i < response.items[0].history.size(); ++i) {
    const Sample& a = response.items[0].history[i - 1];
    const Sample& b = response.items[0].history[i];
    impulse += 0.5 * (b.time - a.time) * (force(a) + force(b));
    defect = std::max(defect, (mass * b.points[0].velocity - impulse).cwiseAbs().maxCoeff());
  }
  EXPECT_EQ(response.items[0].demands.lifted_time, 0);
  return defect / (mass * response.items[0].demands.peak_velocity);
}

// Smooth motion, locked wheels on swaying treads: the trapezoidal rule and the method are of second
// order. (Below 1e-4 the directions taken here show: a wheel's heading is square to its axle, the
// yaw is that of the item's x axis, and they differ by pitch times roll.)
TEST(Momentum, ClosesWithSecondOrderWhileTheTreadsHold) {
  Shaken scene = shaken(false, 0.1);
  for (Caster& caster : scene.item.casters)
    caster.brake_torque = std::numeric_limits<double>::infinity();
  const double coarse = momentum_defect(scene, 0.002), fine = momentum_defect(scene, 0.001);
  EXPECT_LT(fine, coarse / 3.5);  // 4 at second order
}

// Wheels that stop sliding spring back within a millisecond, which the samples do not resolve.
TEST(Momentum, ClosesUnderARecord) { EXPECT_LT(momentum_defect(shaken(false), 0.0005), 2e-5); }

// Each entry of the account comes from its own force and velocity, so their sum tests them all.
TEST(EnergyAccount, ClosesWithSecondOrderUnderARecord) {
  for (const bool swivels : {true, false}) {
    SCOPED_TRACE(swivels);
    const Shaken scene = shaken(swivels);
    const double coarse = run(scene, 0.004).quality.energy_closure;
    const double middle = run(scene, 0.002).quality.energy_closure;
    const double fine = run(scene, 0.001).quality.energy_closure;
    EXPECT_LT(coarse, 1e-5);
    // 4 each time at second order; kinks fall between samples by chance, so 3.
    EXPECT_LT(middle, coarse / 3);
    EXPECT_LT(fine, middle / 3);
  }
}

// A pull has no turning parts, so all that is left is rounding and the residual of the solve.
TEST(EnergyAccount, ClosesForAPull) {
  Scene scene;
  scene.items[0].model = trolley();
  Excitation excitation;
  excitation.forces = {constant_force(40, 3, {0, 0, 0.6})};
  const auto response = simulate(scene, excitation, run_for(8, 0.004, 0.1));
  EXPECT_LT(response.quality.energy_closure, 1e-8);
  EXPECT_GT(response.items[0].energy.work_of_forces, 30);
  EXPECT_LT(std::abs(response.quality.numerical_loss), 1e-6);
}

TEST(EnergyAccount, LossesOnlyGrow) {
  for (const bool swivels : {true, false}) {
    Shaken scene = shaken(swivels);
    for (Caster& caster : scene.item.casters) {
      caster.axle = {0.02, 0.001};
      caster.swivel = {0.03, 0.001};
    }
    const auto response = run(scene, 0.004);
    const EnergyAccount* last = nullptr;
    const double rounding = 1e-9 * response.items[0].energy.loss();
    for (const Sample& s : response.items[0].history) {
      const EnergyAccount& e = s.energy;
      if (last) {
        EXPECT_GE(e.rolling_loss, last->rolling_loss - rounding);
        EXPECT_GE(e.sliding_loss, last->sliding_loss - rounding);
        EXPECT_GE(e.relaxation_loss, last->relaxation_loss - rounding);
        EXPECT_GE(e.tread_loss, last->tread_loss - rounding);
        EXPECT_GE(e.axle_loss, last->axle_loss - rounding);
        EXPECT_GE(e.swivel_loss, last->swivel_loss - rounding);
        EXPECT_EQ(e.damper_loss, 0);
        EXPECT_EQ(e.contact_loss, 0);
      }
      last = &e;
    }
    EXPECT_GT(response.items[0].energy.rolling_loss, 0);
    EXPECT_GT(response.items[0].energy.relaxation_loss, 0);
    EXPECT_GT(response.items[0].energy.tread_loss, 0);
    EXPECT_GT(response.items[0].energy.axle_loss, 0);
  }
}

// A trolley that coasts from v0 to rest turns M v0^2 / 2 + J v0^2 / 2 into W_R = f_r d.
TEST(EnergyAccount, RollingLossIsResistanceTimesDistance) {
  for (const double resistance : {0.01, 0.02, 0.03}) {
    SCOPED_TRACE(resistance);
    ItemOptions options;
    stiffen(options.caster.tread);
    options.caster.tread.rolling_resistance = resistance * options.caster.wheel_radius;
    Scene scene;
    scene.items[0].model = trolley(options);
    scene.items[0].initial.velocity.x() = 1;
    Excitation excitation;
    excitation.fixture = hold_rotations(false, true, false);
    const auto response = simulate(scene, excitation, run_for(12, 0.004, 1));
    const double mass = total_mass(scene.items[0].model),
                 inertia = mass + wheel_inertia_mass(scene.items[0].model);
    const double distance = inertia / (2 * resistance * mass * kG);
    EXPECT_NEAR(response.items[0].demands.residual_displacement_x, distance, 1e-5 * distance);
    EXPECT_NEAR(response.items[0].energy.rolling_loss, resistance * mass * kG * distance,
                1e-5 * inertia / 2);
    EXPECT_NEAR(response.items[0].energy.sliding_loss, 0, 1e-9);
  }
}

// A rolling patch under the force f slips by f / (k_t sigma) of its travel s (relaxation), which
// takes f^2 s / (k_t sigma) for each wheel, and so much less goes into the wheels' turning. In a
// coast, f = f_r - J a2 of all wheels together.
TEST(EnergyAccount, RelaxationLossOfASoftTread) {
  Scene scene;
  scene.items[0].model = trolley();
  scene.items[0].initial.velocity.x() = 1;
  Excitation excitation;
  excitation.fixture = hold_rotations(false, true, false);
  const Tread& tread = scene.items[0].model.casters[0].tread;
  const double mass = total_mass(scene.items[0].model),
               inertia = wheel_inertia_mass(scene.items[0].model);
  const double resistance = tread.rolling_resistance / 0.05 * mass * kG;
  const double a2 = resistance / (mass + inertia);
  constexpr double kDuration = 2;
  const auto response = simulate(scene, excitation, run_for(kDuration, 0.001, kDuration));
  const double travel = kDuration - a2 * kDuration * kDuration / 2;
  const double force = (resistance - inertia * a2) / 4;
  const double slip = force / (tread.tangential_stiffness * tread.relaxation_length);
  // The start, where the force builds up over a travel of sigma, and slip^2 are left out.
  const double start = tread.relaxation_length / travel;
  EXPECT_NEAR(response.items[0].energy.relaxation_loss, 4 * force * slip * travel,
              2 * (start + slip) * 4 * force * slip * travel);
  EXPECT_NEAR(response.items[0].energy.rolling_loss, resistance * travel * (1 - slip),
              start * resistance * travel * slip + 1e-4 * resistance * travel);
}

// A block that slides from v0 to rest: mu M g d = M v0^2 / 2.
TEST(EnergyAccount, SlidingLossIsFrictionTimesDistance) {
  for (const double mu : {0.1, 0.5}) {
    SCOPED_TRACE(mu);
    ItemOptions options;
    stiffen(options.caster.tread);
    options.caster.tread.static_friction = options.caster.tread.kinetic_friction = mu;
    Scene scene;
    scene.items[0].model = locked_block(options);
    scene.items[0].initial.velocity = {0.8, 0.6, 0};
    scene.items[0].initial.wheels_roll = false;
    Excitation excitation;
    excitation.fixture = hold_rotations();
    const auto response = simulate(scene, excitation, run_for(2, 0.001, 1));
    const double loss = total_mass(scene.items[0].model) / 2;
    EXPECT_NEAR(response.items[0].energy.sliding_loss, loss, 1e-5 * loss);
    EXPECT_NEAR(response.items[0].demands.residual_displacement, 1 / (2 * mu * kG),
                1e-5 / (2 * mu * kG));
  }
}

// A slipping brake takes its torque times the angle: tau d / R of each wheel, as f_r = tau / R.
TEST(EnergyAccount, BrakeLossIsTorqueTimesAngle) {
  for (const double torque : {0.5, 2.0}) {  // below mu N R = 7 N m: the wheels roll
    SCOPED_TRACE(torque);
    ItemOptions options;
    stiffen(options.caster.tread);
    options.caster.tread.rolling_resistance = 0;
    options.caster.brake_torque = torque;
    Scene scene;
    scene.items[0].model = trolley(options);
    scene.items[0].initial.velocity.x() = 1;
    Excitation excitation;
    excitation.fixture = hold_rotations(false, true, false);
    const auto response = simulate(scene, excitation, run_for(4, 0.001, 1));
    const double inertia =
        total_mass(scene.items[0].model) + wheel_inertia_mass(scene.items[0].model);
    const double distance = inertia / 2 / (4 * torque / 0.05);
    EXPECT_NEAR(response.items[0].demands.residual_displacement_x, distance, 1e-4 * distance);
    EXPECT_NEAR(response.items[0].energy.axle_loss, inertia / 2, 1e-4 * inertia / 2);
  }
}

// A caster towed from a heading psi0 turns into line; its swivel friction takes c |psi0 - psi|.
TEST(EnergyAccount, SwivelLossIsTorqueTimesAngle) {
  for (const double start : {0.5, 1.5, 2.5}) {
    SCOPED_TRACE(start);
    Caster caster = rubber_caster();
    caster.swivel.coulomb = 0.05;
    caster.heading = start;
    Scene scene;
    scene.items[0].model = single_caster(25, caster);
    Excitation excitation;
    excitation.fixture = tow(0.3);
    const auto response = simulate(scene, excitation, run_for(2, 0.001, 0.001));
    double turned = 0, last = start;
    for (const Sample& s : response.items[0].history) {
      turned += std::abs(s.wheels[0].swivel_angle - last);
      last = s.wheels[0].swivel_angle;
    }
    EXPECT_GT(turned, 0.9 * start);
    // Elastic wind-up of the stuck bearing: c / k = 0.05 / 2500 rad each time it turns round.
    EXPECT_NEAR(response.items[0].energy.swivel_loss, 0.05 * turned, 0.05 * 1e-3);
  }
}

}  // namespace
}  // namespace gurney
