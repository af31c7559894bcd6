#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/units.h"
#include "engine/run/simulate.h"
#include "studies/verification/scenes/scenes.h"

// What must be kept whatever happens: momentum (impulse of all forces) and energy. The losses of
// simple motions are in studies/verification/cases.
namespace gurney {
namespace {

using namespace scenes;

constexpr double kG = kStandardGravity;

// A trolley on rigid casters at odd headings under three components: it rolls, skids and turns.
// Being one rigid body (but for wheel spin, which carries no linear momentum), M v of its centre of
// mass must change by the impulse of the wheel forces, gravity and the floor's inertia.
struct Shaken {
  EquipmentModel item;
  FloorMotion floor;
};

Shaken shaken(bool swivels, double amplitude = 0.3) {
  ItemOptions options;
  options.caster.swivels = swivels;
  options.headings = {0.2, -0.3, 0.1, 0.4};
  Shaken result;
  result.item = trolley(options);
  result.floor = floor_motion(0.004, 4, {1, 0.6, 0.4}, [=](double t) {
    return amplitude * kG * std::sin(std::numbers::pi * t / 4) *
           std::sin(2 * std::numbers::pi * 1.3 * t);
  });
  return result;
}

Response run(const Shaken& shaken, double time_step) {
  Scene scene = scene_of(shaken.item);
  return simulate(scene, shaken.floor, run_for(4, time_step, time_step));
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
    return Vector3(sum - mass * scene.floor.acceleration_at(s.time));
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
  Scene scene = scene_of(trolley());
  scene.items[0].loads = {constant_force(40, 3, {0, 0, 0.6})};
  const auto response = simulate(scene, {}, run_for(8, 0.004, 0.1));
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

}  // namespace
}  // namespace gurney
