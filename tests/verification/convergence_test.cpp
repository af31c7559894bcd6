#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "engine/base/units.h"
#include "engine/simulate.h"
#include "studies/verification/scenes/small_scenes.h"

namespace gurney {
namespace {

/// Order from three runs at h, h/2, h/4 (Richardson): log2 of |y_h - y_h/2| / |y_h/2 - y_h/4|.
double observed_order(const std::function<double(double step)>& run, double step) {
  const double a = run(step), b = run(step / 2), c = run(step / 4);
  return std::log2(std::abs(a - b) / std::abs(b - c));
}

// The method is of second order on smooth problems; at finite steps terms of third order move the
// observed order by about h times a rate of the problem, here below 0.2. A first-order method
// shows 1.
constexpr double kOrder = 2, kSpread = 0.25;

TEST(Convergence, TowedCasterIsOfSecondOrder) {
  Tread tread = small::bare_tread(3e7, 1e7);
  tread.tangential_damping = 100;
  tread.static_friction = tread.kinetic_friction = 5;
  for (const double heading : {40.0, 120.0}) {
    const auto angle = [&](double step) {
      const auto towed = small::towed_caster(1, 0.034, heading, tread);
      return simulate(towed.scene, towed.excitation, small::settings_for(step, 0.048))
          .items[0]
          .history.back()
          .wheels[0]
          .swivel_angle;
    };
    EXPECT_NEAR(observed_order(angle, 0.002), kOrder, kSpread) << "heading " << heading;
  }
}

TEST(Convergence, HeaveIsOfSecondOrder) {
  Scene scene;
  scene.items[0].model = small::trolley({0, 0, 0, 0}, small::bare_tread(3e5, 1e5));
  scene.items[0].initial.velocity = {0, 0, 0.01};
  const auto height = [&](double step) {
    return simulate(scene, {}, small::settings_for(step, 0.064))
        .items[0]
        .history.back()
        .displacement.z();
  };
  EXPECT_NEAR(observed_order(height, 0.002), kOrder, kSpread);
}

TEST(Convergence, CoastingAndTurningTrolleyIsOfSecondOrder) {
  Scene scene;
  Tread tread = small::bare_tread(3e5, 1e5);
  tread.normal_damping = 500;
  tread.tangential_damping = 50;
  tread.static_friction = tread.kinetic_friction = 5;
  scene.items[0].model = small::trolley({20, 60, -30, 100}, tread);
  scene.items[0].initial.velocity = {0.3, 0.1, 0};
  scene.items[0].initial.yaw_rate = 0.5;
  const auto run = [&](double step) {
    return simulate(scene, {}, small::settings_for(step, 0.8)).items[0].history.back();
  };
  EXPECT_NEAR(observed_order([&](double h) { return run(h).displacement.x(); }, 0.002), kOrder,
              kSpread);
  EXPECT_NEAR(observed_order([&](double h) { return run(h).displacement.y(); }, 0.002), kOrder,
              kSpread);
  EXPECT_NEAR(observed_order([&](double h) { return run(h).yaw; }, 0.002), kOrder, kSpread);
}

TEST(Convergence, ARecordAtFourMillisecondsAgainstAQuarter) {
  const std::vector<std::vector<double>> angles = {
      {10, 100, 200, 300}, {45, 45, 45, 45}, {0, 75, 150, 225}};
  std::vector<double> displacement, acceleration, force;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    Scene scene;
    scene.items[0].model = small::trolley(angles[i], Tread());
    Excitation excitation;
    excitation.floor = small::noise_record(10 + i, 10, {4, 3, 2});
    const auto demands = [&](double step) {
      const Response response = simulate(scene, excitation, small::settings_for(step, 11, 1000));
      EXPECT_EQ(response.outcome, Outcome::kStopped) << response.cause;
      EXPECT_EQ(response.quality.unconverged_steps, 0);
      EXPECT_LT(response.quality.energy_closure, 0.01);
      return response.items[0].demands;
    };
    const Demands coarse = demands(0.004), fine = demands(2.5e-4);
    EXPECT_GT(fine.peak_displacement, 0.02);
    const auto error = [](double a, double b) { return std::abs(a / b - 1); };
    displacement.push_back(error(coarse.peak_displacement, fine.peak_displacement));
    acceleration.push_back(error(coarse.points[0].peak_absolute_acceleration,
                                 fine.points[0].peak_absolute_acceleration));
    force.push_back(error(coarse.peak_normal_force, fine.peak_normal_force));
  }
  const auto median = [](std::vector<double> errors) {
    std::sort(errors.begin(), errors.end());
    return errors[errors.size() / 2];
  };
  EXPECT_LT(median(displacement), 0.005);
  EXPECT_LT(median(acceleration), 0.02);
  EXPECT_LT(median(force), 0.02);
}

}  // namespace
}  // namespace gurney
